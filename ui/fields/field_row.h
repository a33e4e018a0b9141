// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/style/contrast.h"

#include <QObject>
#include <QString>

class QGridLayout;
class QLabel;
class QStyle;
class QToolButton;
class QWidget;

namespace axiscomp::ui {

class BusyMark;

/// The fixed texts of a field.
struct FieldTexts {
    QString label; ///< with its mnemonic
    QString toolTip;
    QString description; ///< for screen readers; what the field is for
};

/// One field of the page: its label, its editor, a button that puts the drive's value back, and a
/// line below the editor that says what is wrong, what speaks against the value, that it is
/// changed, or what it means, in this order of importance; beside it what is proposed. Says the
/// same to screen readers.
class FieldRow : public QObject {
    Q_OBJECT

public:
    /// Takes the editor, which has an object name; style draws the frame of a changed editor.
    FieldRow(QWidget* editor, QStyle* style, QWidget* parent);

    /// Two rows of the grid: columns label, editor, buttons.
    void addTo(QGridLayout& grid, int firstRow);

    [[nodiscard]] QWidget& editor();
    /// Where the label's key leads, for an editor of several parts.
    void setBuddy(QWidget& part);
    [[nodiscard]] const FieldTexts& texts() const;
    void setTexts(const FieldTexts& texts);
    /// Whether there is a button for putting the drive's value back.
    void setRevertible(bool isRevertible);
    void setVisible(bool isVisible);
    [[nodiscard]] bool isVisible() const;
    void setEnabled(bool isEnabled);

    /// driveText: the drive's value in words.
    void setDirty(bool isDirty, const QString& driveText);
    [[nodiscard]] bool isDirty() const;
    void setProblem(const QString& sentence);
    void setInformation(const QString& text);
    /// What speaks against the value that is chosen; it may be right all the same.
    void setWarning(const QString& sentence);
    /// A value that is offered, in words, with a button that takes it; empty: none.
    void setProposal(const QString& text);
    /// What the chosen value is at the moment, at the end of the line; greyed when it is not live.
    void setCurrent(const QString& text, bool isLive);
    /// The value in full, for the tooltip of an editor that may be too narrow for it.
    void setWholeValue(const QString& text);
    void setBusy(bool isBusy);
    /// What the line below the editor says now.
    [[nodiscard]] QString note() const;

Q_SIGNALS:
    void revertRequested();
    void proposalTaken();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void showState();
    void showProposal();
    [[nodiscard]] QString noteText() const;
    [[nodiscard]] Tone tone() const;
    void showContextMenu(const QPoint& position);
    [[nodiscard]] QString changedText() const;

    QWidget* m_editor;
    QLabel* m_label;
    QLabel* m_note;
    QLabel* m_noteSymbol;
    QWidget* m_noteLine;
    QWidget* m_buttons;
    QToolButton* m_revert;
    QLabel* m_current;
    QToolButton* m_take;
    BusyMark* m_busy;
    FieldTexts m_texts;
    QString m_driveText;
    QString m_problem;
    QString m_warning;
    QString m_proposal;
    QString m_information;
    QString m_wholeValue;
    bool m_isDirty = false;
    bool m_isRevertible = true;
    bool m_isVisible = true;
};

} // namespace axiscomp::ui
