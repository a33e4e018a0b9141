// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/controller/wizard_controller.h"
#include "ui/session/endpoint_probe.h"

#include <QDialog>

class QDialogButtonBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace axiscomp::ui {

class BusyMark;
class CertificateButton;
class ToneLabel;

/// Which drives the program talks to: add, change, remove, test. Passwords that are part of an
/// address are used as long as the program runs and shown nowhere.
class ConnectionsDialog : public QDialog {
    Q_OBJECT

public:
    ConnectionsDialog(
        const WizardController& controller, ProbeOptions options, QWidget* parent = nullptr);

Q_SIGNALS:
    void endpointsAccepted(const QStringList& endpoints);
    void certificateTrusted();

protected:
    void changeEvent(QEvent* event) override;

private:
    void build();
    void buildList();
    void connectButtons();
    void retranslate();
    void addItem(const QString& endpoint);
    void showKnownStates();
    void showState(QTreeWidgetItem& item, const Result<DriveIdentity>& identity);
    void testCurrent();
    void find();
    void test(const QString& endpoint);
    void startEditing(QTreeWidgetItem* item);
    void checkAddress();
    void takeAddress(const QString& endpoint, const Result<DriveIdentity>& identity);
    void removeCurrent();
    void showNote(const QString& text, bool isError);
    void updateButtons();
    [[nodiscard]] QTreeWidgetItem* itemOf(const QString& endpoint) const;
    [[nodiscard]] QStringList endpoints() const;

    const WizardController& m_controller;
    ProbeOptions m_options;
    EndpointProbe m_probe;
    QString m_edited; ///< the endpoint that is being changed; empty: a new one is added
    QLabel* m_introduction;
    QTreeWidget* m_list;
    QPushButton* m_edit;
    QPushButton* m_remove;
    QPushButton* m_test;
    CertificateButton* m_certificate;
    QPushButton* m_find;
    QPushButton* m_demo;
    QLabel* m_addressLabel;
    QLineEdit* m_address;
    QPushButton* m_add;
    BusyMark* m_busy;
    ToneLabel* m_note;
    QDialogButtonBox* m_buttons;
};

} // namespace axiscomp::ui
