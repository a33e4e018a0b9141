// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/accessible_role.h"

#include <QAccessibleWidget>
#include <QVariant>

namespace axiscomp::ui {

namespace {

constexpr const char* accessibleRoleProperty = "axiscompAccessibleRole";

class RoleInterface final : public QAccessibleWidget {
public:
    RoleInterface(QWidget* widget, QAccessible::Role role) : QAccessibleWidget(widget, role) { }
};

QAccessibleInterface* interfaceWithRole(const QString& /*className*/, QObject* object)
{
    const QVariant role =
        object && object->isWidgetType() ? object->property(accessibleRoleProperty) : QVariant();
    return role.isValid() ? new RoleInterface(
               static_cast<QWidget*>(object), static_cast<QAccessible::Role>(role.toInt()))
                          : nullptr;
}

} // namespace

void setAccessibleRole(QWidget& widget, QAccessible::Role role)
{
    QAccessible::installFactory(interfaceWithRole); // once, however often it is called
    widget.setProperty(accessibleRoleProperty, static_cast<int>(role));
}

void announceName(QWidget& widget, const QString& name)
{
    if (widget.accessibleName() != name)
        widget.setAccessibleName(name);
}

} // namespace axiscomp::ui
