// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/link_attachment.h"

#include <QObject>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace axiscomp::test {

/// What every DriveLink must do, whatever is between it and the drive. Each row runs over each
/// attachment.
class LinkContract : public QObject {
    Q_OBJECT

public:
    explicit LinkContract(std::vector<AttachmentKind> kinds);
    ~LinkContract() override;

private Q_SLOTS:
    void initTestCase_data();
    void init();
    void cleanup();

    void identifiesTheDrive_data();
    void identifiesTheDrive();
    void readsRegistersInTheOrderAskedFor_data();
    void readsRegistersInTheOrderAskedFor();
    void readsNothingWhenNothingIsAskedFor();
    void takesPathsInBothSpellings();
    void namesTheRegisterThatIsUnknown();
    void readsATreeByItsPrefix_data();
    void readsATreeByItsPrefix();
    void keepsEveryValueExactly_data();
    void keepsEveryValueExactly();
    void writesSeveralRegistersAtOnce();
    void writesAllOrNone_data();
    void writesAllOrNone();
    void listsEverySlot();
    void bringsATableToEverySlotAndBack();
    void downloadsNothingFromAnEmptySlot();
    void refusesAFile_data();
    void refusesAFile();
    void refusesWhileTheCompensationIsActive();
    void saysHowLongFlashWearLasts();
    void reportsProgressThatOnlyGrows();
    void doesNothingOnceItIsStopped();
    void endsAtItsDeadline_data();
    void endsAtItsDeadline();
    void reportsWhatTheDriveRefuses_data();
    void reportsWhatTheDriveRefuses();
    void reportsALostConnectionWhenTheDriveReboots();
    void neverTakesAGarbledReplyForAnAnswer();
    void storesSomethingElseWhenAskedTo();
    void keepsTheOldFileWhenAnUploadIsCut_data();
    void keepsTheOldFileWhenAnUploadIsCut();
    void neverTakesPartOfAFileForTheWhole();
    void worksAgainAfterAFault_data();
    void worksAgainAfterAFault();

private:
    struct Scene;
    [[nodiscard]] const AttachmentKind& kind() const;
    [[nodiscard]] DriveLink& link();
    [[nodiscard]] drivecomm::VirtualDrive& drive();
    void build(int axes);

    std::vector<AttachmentKind> m_kinds;
    std::unique_ptr<Scene> m_scene;
};

} // namespace axiscomp::test
