// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/capture/serial_instrument.h"
#include "drivecomm/virtualdrive/serial/pseudo_terminal.h"
#include "tests/support/patience.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QDeadlineTimer>
#include <QTest>

#include <fcntl.h>
#include <sys/ioctl.h>
#include <thread>
#include <unistd.h>

namespace tst_serialinstrument {

using namespace axiscomp;
using namespace axiscomp::drivecomm;
using namespace std::chrono_literals;

class tst_SerialInstrument : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    /// A drive that answers slowly leaves more between two readings than the system gives at once;
    /// what stayed would be taken for a line of the next reading.
    void aReadingTakesTheNewestOfAllLinesThatWait()
    {
        const auto terminal = PseudoTerminal::open({});
        VERIFY_RESULT(terminal);
        // Before the instrument has the port for itself.
        const FileDescriptor device(
            ::open(terminal->device().c_str(), O_RDONLY | O_NOCTTY | O_CLOEXEC));
        QVERIFY(device.isOpen());
        auto reader = ReferenceLineReader::make({}, false);
        VERIFY_RESULT(reader);
        const auto instrument =
            SerialInstrument::open("serial:" + terminal->device() + "?baud=115200", {},
                ReferenceLines(*std::move(reader), 1s));
        VERIFY_RESULT(instrument);
        std::string said = "\n"; // the end of the line in which the port was opened
        for (int n = 0; n < 900; ++n)
            said += "1.0000 mm\n";
        said += "2.0000 mm\n";
        QCOMPARE(::write(terminal->master().get(), said.data(), said.size()),
            static_cast<ssize_t>(said.size()));
        const auto waiting = [&] {
            int bytes = 0;
            return ::ioctl(device.get(), FIONREAD, &bytes) == 0 ? bytes : 0;
        };
        // Without the event loop, in which the port would be read.
        const QDeadlineTimer patience(test::patienceMs);
        while (waiting() <= 2048 && !patience.hasExpired())
            std::this_thread::yield();
        QVERIFY(waiting() > 2048);
        const InstrumentReading reading = (*instrument)->at(10s);
        QVERIFY2(reading.problem.isEmpty(), reading.problem.english().c_str());
        QCOMPARE(reading.position, 2.0);
    }
};

AXISCOMP_TEST(tst_SerialInstrument)

} // namespace tst_serialinstrument

#include "tst_serialinstrument.moc"
