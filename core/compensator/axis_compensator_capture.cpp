// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/wall_time.h"
#include "core/compensator/axis_compensator_p.h"
#include "core/drive/register_value.h"

#include <utility>

namespace axiscomp {

namespace {

tl::unexpected<Error> cannotCapture(Text reason)
{
    return fail(ErrorCode::InvalidArgument, {{"reason", std::move(reason)}});
}

/// The path of a register that is named as those of sources are.
Result<std::string> capturedRegister(
    AxisCompensator& compensator, const std::string& text, const OperationOptions& options)
{
    const auto source = compensator.resolveSource(text, options);
    if (source)
        return source->path;
    // It is there, and what it is not good for is said of an instrument, not of a source.
    if (source.error().code == ErrorCode::SourceWrongType)
        return normalisedPath(text);
    return fail(source.error());
}

} // namespace

Result<CaptureRun> AxisCompensator::beginCapture(
    int axis, const CaptureRequest& request, const OperationOptions& options)
{
    using Kind = CaptureReference::Kind;
    const Kind kind = request.reference.kind;
    CaptureReference reference = request.reference;
    AXISCOMP_TRY(const auto status, this->status(axis, options));
    CaptureRegisters registers;
    if (!request.encoder.empty()) {
        AXISCOMP_TRY(registers.encoder, capturedRegister(*this, request.encoder, options));
    } else {
        AXISCOMP_TRY(const auto shortlist, sourceShortlist(options));
        registers.encoder = encoderRegister(d->profile, shortlist, axis);
    }
    if (registers.encoder.empty())
        return cannotCapture(AXISCOMP_TEXT("Error",
            "the drive profile does not say which register is the encoder of the axis: name it"));
    if (kind == Kind::Register) {
        AXISCOMP_TRY(reference.source, capturedRegister(*this, reference.source, options));
        registers.reference = reference.source;
    }
    const RegisterAccess access = d->access(options);
    AXISCOMP_TRY(auto readings,
        AxisReadings::open(d->link, d->profile, status, request.plan, registers,
            kind == Kind::Register ? reference.scale : ReferenceScale{}, access.exchange()));
    std::optional<Instrument> instrument;
    std::optional<ReferenceLineReader> typed;
    if (kind == Kind::Typed) {
        // The question names the unit.
        ReferenceScale scale = reference.scale;
        if (scale.unit.empty())
            scale.unit = request.plan.isAngular ? "deg" : "mm";
        AXISCOMP_TRY(
            typed, ReferenceLineReader::make(scale, request.plan.isAngular, request.finder));
    } else if (kind != Kind::Register) {
        AXISCOMP_TRY(instrument, request.openInstrument());
    }
    AXISCOMP_TRY(auto file,
        RunFile::open(request.file, request.plan,
            {readings.state(), reference.text(),
                utcText(std::chrono::floor<std::chrono::seconds>(d->clock())), registers.encoder,
                status.drive, readings.tablePlace()}));
    CaptureRun run(std::move(readings), std::move(file), request.plan, request.rules, status.drive);
    run.useConnection(d->connection);
    if (instrument)
        run.setInstrument(*std::move(instrument));
    if (typed)
        run.setTyped(*std::move(typed));
    return run;
}

Result<CaptureNews> AxisCompensator::readCapture(CaptureRun& run,
    const std::function<std::chrono::nanoseconds()>& now, const OperationOptions& options)
{
    run.useConnection(d->connection);
    return run.read(d->link, now, d->access(options).exchange());
}

} // namespace axiscomp
