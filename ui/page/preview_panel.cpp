// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/page/preview_panel.h"

#include "core/drive/axis_target.h"
#include "core/drive/drive_profile.h"
#include "core/neutral/lookup_note.h"
#include "core/table/position_unit.h"
#include "core/write/lookup_side.h"
#include "ui/controller/wizard_controller.h"
#include "ui/data/table_view_model.h"
#include "ui/page/file_lines_view.h"
#include "ui/page/problem_list.h"
#include "ui/page/write_preview.h"
#include "ui/plot/controller_combo.h"
#include "ui/plot/slice_gallery.h"
#include "ui/plot/surface_view.h"
#include "ui/plot/values_view.h"
#include "ui/plot/vector_view.h"
#include "ui/style/contrast.h"
#include "ui/style/plain_label.h"
#include "ui/style/symbols.h"
#include "ui/style/tone_label.h"
#include "ui/text/message_text.h"
#include "ui/text/value_text.h"

#include <QBoxLayout>
#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QShortcut>
#include <QStackedWidget>
#include <QTabBar>
#include <QTabWidget>

#include <algorithm>
#include <array>

namespace axiscomp::ui {

namespace {

ToneLabel* selectableLabel(const char* name)
{
    auto* label = new ToneLabel;
    label->setObjectName(QLatin1StringView(name));
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    return label;
}

/// The smallest slot that a table of this size fits into.
const TableSlot* smallestSlot(const DriveProfile& profile, std::size_t bytes)
{
    const TableSlot* smallest = nullptr;
    for (const TableSlot& slot : profile.tableSlots) {
        if (slot.maximumSize >= bytes && (!smallest || slot.maximumSize < smallest->maximumSize))
            smallest = &slot;
    }
    return smallest;
}

} // namespace

PreviewPanel::PreviewPanel(
    WizardController& controller, const DriveProfile& profile, QWidget* parent)
    : QWidget(parent)
    , m_controller(controller)
    , m_profile(profile)
    , m_example(new QPushButton)
    , m_stack(new QStackedWidget)
    , m_tabs(new QTabWidget)
    , m_shown(new TableViewModel(this))
    , m_plot(new TablePlot(*m_shown))
    , m_surface(new SurfaceView(*m_shown, this))
    , m_slices(new SliceGallery(*m_shown, this))
    , m_vectors(new VectorView(*m_shown, this))
    , m_applied(new ControllerCombo)
    , m_valuesStack(new QStackedWidget)
    , m_values(new ValuesView(*m_shown))
    , m_lines(new FileLinesView)
    , m_problems(new ProblemList(this))
    , m_writePreview(new WritePreview(controller))
    , m_notes(new QWidget)
    , m_facts(selectableLabel("tableFacts"))
    , m_size(selectableLabel("tableSize"))
    , m_warnings(selectableLabel("tableWarnings"))
    , m_sign(selectableLabel("signSentence"))
{
    setObjectName(QStringLiteral("previewPanel"));
    build();
    addTabShortcuts();
    connectController();
    connectProblems();
    retranslate();
    showTables();
    showProblems();
}

void PreviewPanel::build()
{
    m_plot->setObjectName(QStringLiteral("tablePlot"));
    m_tabs->setObjectName(QStringLiteral("previewTabs"));
    m_tabs->setDocumentMode(true);
    m_valuesStack->setObjectName(QStringLiteral("valuesStack"));
    m_valuesStack->addWidget(m_values);
    m_valuesStack->addWidget(m_lines);
    m_tabs->addTab(m_plot, QString());
    m_tabs->addTab(m_valuesStack, QString());
    m_example->setObjectName(QStringLiteral("saveExampleButton"));
    m_example->setIcon(symbolIcon(Symbol::Save));
    m_example->setAutoDefault(true);
    // Above picture and values, since it is about both; and the page can be narrower.
    constexpr int appliedLetters = 12;
    m_applied->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_applied->setMinimumContentsLength(appliedLetters);
    auto* corner = new QWidget;
    auto* tools = new QHBoxLayout(corner);
    tools->setContentsMargins(0, 0, 0, 2);
    tools->addWidget(m_applied);
    tools->addWidget(m_example);
    m_tabs->setCornerWidget(corner);
    m_surface->setObjectName(QStringLiteral("surfaceView"));
    m_slices->setObjectName(QStringLiteral("sliceGallery"));
    m_vectors->setObjectName(QStringLiteral("vectorView"));
    for (QWidget* page :
        std::initializer_list<QWidget*>{m_surface, m_slices, m_vectors, m_problems})
        page->hide();
    m_stack->addWidget(m_tabs);
    m_stack->addWidget(m_writePreview);
    QFont signFont = m_sign->font();
    signFont.setItalic(true);
    m_sign->setFont(signFont);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(6);
    layout->addWidget(m_stack, 1);
    auto* notes = new QVBoxLayout(m_notes);
    notes->setContentsMargins(0, 0, 0, 0);
    notes->setSpacing(6);
    m_warnings->setTone(Tone::Warning);
    for (QLabel* label : std::initializer_list<QLabel*>{m_facts, m_size, m_warnings, m_sign})
        notes->addWidget(label);
    layout->addWidget(m_notes);
}

void PreviewPanel::addTabShortcuts()
{
    constexpr int mostTabs = 6;
    for (int index = 0; index < mostTabs; ++index) {
        auto* shortcut = new QShortcut(QKeySequence(Qt::CTRL | (Qt::Key_1 + index)), this);
        connect(shortcut, &QShortcut::activated, this, [this, index] {
            if (index >= m_tabs->count() || isWritePreviewShown())
                return;
            m_tabs->setCurrentIndex(index);
            m_tabs->tabBar()->setFocus(Qt::ShortcutFocusReason);
        });
    }
}

void PreviewPanel::connectProblems()
{
    connect(m_problems, &ProblemList::opened, this,
        [this](const QString& path, const ProblemPlace& place) {
            m_lines->showProblem(path, place);
            m_valuesStack->setCurrentWidget(m_lines);
            m_tabs->setCurrentWidget(m_valuesStack);
        });
    connect(
        m_problems, &ProblemList::dimensionsChosen, &m_controller, &WizardController::openDataAs);
    connect(m_lines, &FileLinesView::stepRequested, m_problems, &ProblemList::step);
    connect(m_lines, &FileLinesView::closeRequested, this,
        [this] { m_valuesStack->setCurrentWidget(m_values); });
}

void PreviewPanel::connectController()
{
    connect(m_shown, &TableViewModel::changed, this, &PreviewPanel::showFacts);
    connect(m_shown, &TableViewModel::changed, this, &PreviewPanel::showTabs);
    connect(m_slices, &SliceGallery::chosen, this, [this] { m_tabs->setCurrentWidget(m_plot); });
    connect(&m_controller, &WizardController::dataFileChanged, this, &PreviewPanel::showVectors);
    connect(&m_controller, &WizardController::currentAxisChanged, this, &PreviewPanel::showOrigin);
    connect(m_applied, &ControllerCombo::changed, this, &PreviewPanel::showApplied);
    connect(m_example, &QPushButton::clicked, this,
        [this] { Q_EMIT saveExampleRequested(m_controller.setup().edited().dimensionality); });
    connect(
        &m_controller, &WizardController::selectedTableChanged, this, &PreviewPanel::showTables);
    connect(&m_controller, &WizardController::statusChanged, this, &PreviewPanel::showTables);
    connect(&m_controller, &WizardController::axesChanged, this, &PreviewPanel::showTravel);
    connect(&m_controller, &WizardController::liveChanged, this, &PreviewPanel::showMarker);
    connect(&m_controller, &WizardController::dataFileChanged, this, &PreviewPanel::showProblems);
    connect(&m_controller.setup(), &SetupModel::fieldChanged, this, [this](Field field) {
        if (field == Field::Dimensionality)
            showExample();
        showCompared();
        showMarker();
        showTravel();
    });
}

WritePreview& PreviewPanel::writePreview()
{
    return *m_writePreview;
}

void PreviewPanel::showWritePreview(bool isShown)
{
    m_stack->setCurrentWidget(isShown ? static_cast<QWidget*>(m_writePreview) : m_tabs);
    // The preview says all of this itself, of the table that it is about.
    m_notes->setVisible(!isShown);
    if (isShown)
        m_writePreview->showPlan();
}

bool PreviewPanel::isWritePreviewShown() const
{
    return m_stack->currentWidget() == m_writePreview;
}

void PreviewPanel::retranslate()
{
    m_example->setText(tr("Save Exa&mple…"));
    for (QWidget* page :
        std::initializer_list<QWidget*>{m_plot, m_valuesStack, m_surface, m_slices, m_vectors}) {
        const int index = m_tabs->indexOf(page);
        if (index >= 0)
            m_tabs->setTabText(index, titleOf(*page));
    }
    showTabTips();
    m_applied->retranslate();
    m_values->retranslate();
    m_lines->retranslate();
    m_problems->retranslate();
    m_writePreview->retranslate();
    showExample();
    showFacts();
    showProblems();
}

void PreviewPanel::showExample()
{
    const int dimensionality = m_controller.setup().edited().dimensionality;
    m_example->setToolTip(
        tr("Save a small %1D calibration file as an example").arg(dimensionality));
    m_example->setAccessibleDescription(m_example->toolTip());
}

void PreviewPanel::showTables()
{
    m_applied->setTable(m_controller.selectedTable(), m_controller.selectedPlace());
    showApplied();
    showTabs();
}

void PreviewPanel::showApplied()
{
    showCompared();
    showOrigin();
    showTravel();
    showMarker();
    showFacts();
}

/// A table that will be looked up over other sources has no difference to the drive's.
void PreviewPanel::showCompared()
{
    const SetupModel& setup = m_controller.setup();
    CompensationSetup chosen;
    chosen.dimensionality = setup.edited().dimensionality;
    chosen.sources = setup.edited().sources;
    m_shown->setTables(m_applied->table(), m_controller.driveTable(),
        haveSameSources(chosen, setup.baseline()) ? TableSources::Same : TableSources::Other);
}

QString PreviewPanel::titleOf(const QWidget& page) const
{
    if (&page == m_plot)
        return tr("Picture");
    if (&page == m_valuesStack)
        return tr("Values");
    if (&page == m_surface)
        return tr("Surface");
    return &page == m_slices ? tr("All slices") : tr("Two axes");
}

/// What is shown stays while the next table is read; an axis without one has none to wait for.
void PreviewPanel::showTabs()
{
    const auto& table = m_shown->table();
    const auto& status = m_controller.status();
    const bool isAwaited =
        !status || status->table || m_controller.setup().edited().table.fileTable;
    if (!table && isAwaited)
        return;
    const int dimensions = table ? table->grid.dimensions() : 1;
    showTab(*m_surface, dimensions > 1);
    showTab(*m_slices, dimensions > 2);
}

/// A page that is not always there, in its place.
void PreviewPanel::showTab(QWidget& page, bool isWanted)
{
    const int index = m_tabs->indexOf(&page);
    if (isWanted == (index >= 0))
        return;
    if (isWanted) {
        int place = m_tabs->indexOf(m_valuesStack) + 1;
        for (const QWidget* before :
            std::initializer_list<const QWidget*>{m_surface, m_slices, m_vectors}) {
            if (before == &page)
                break;
            place += m_tabs->widget(place) == before ? 1 : 0;
        }
        m_tabs->insertTab(place, &page, titleOf(page));
    } else {
        m_tabs->removeTab(index);
        page.hide();
    }
    showTabTips();
}

void PreviewPanel::showTabTips()
{
    for (int index = 0; index < m_tabs->count(); ++index)
        if (m_tabs->widget(index) != m_problems)
            m_tabs->setTabToolTip(
                index, tr("%1 (Ctrl+%2)").arg(m_tabs->tabText(index)).arg(index + 1));
}

/// The errors of two axes, when the open file has them.
void PreviewPanel::showVectors()
{
    const auto& file = m_controller.dataFile().data;
    const bool canShow = VectorView::canShow(file);
    m_vectors->setData(canShow ? file : nullptr);
    showTab(*m_vectors, canShow);
    showMarker();
    showOrigin();
}

/// Of saved pictures.
void PreviewPanel::showOrigin()
{
    PictureOrigin origin;
    const auto current = static_cast<std::size_t>(m_controller.currentAxis());
    if (current < m_controller.axes().size()) {
        const AxisEntry& entry = m_controller.axes()[current];
        origin.drive = entry.driveName;
        origin.axis = QString::fromStdString(entry.axis.name);
    }
    const DataFile& file = m_controller.dataFile();
    const QString name = file.data ? QFileInfo(file.path).fileName() : QString();
    m_vectors->setOrigin({origin.drive, origin.axis, name});
    if (m_controller.setup().edited().table.fileTable)
        origin.file = name;
    m_plot->setOrigin(origin);
    m_plot->setValuesOrigin(valuesOrigin());
    m_surface->setOrigin(origin);
}

TablePlot::ValuesOrigin PreviewPanel::valuesOrigin() const
{
    TablePlot::ValuesOrigin origin{m_applied->isOfDrive(), {}, {}};
    if (const auto& status = m_controller.status())
        origin.onDrive = withLookupNote({},
            lookupAtSources(m_profile, status->axis.index, axiscomp::sourcePaths(status->setup)));
    const DataFile& file = m_controller.dataFile();
    if (!m_controller.setup().edited().table.fileTable)
        origin.selected = origin.onDrive;
    else if (file.data)
        origin.selected = withLookupNote(file.data->notes, file.lookupAt);
    return origin;
}

void PreviewPanel::showMarker()
{
    const auto& status = m_controller.status();
    const auto table = m_controller.selectedTable();
    // The drive's values are places in the picture only where it looks up what the page shows.
    const EditedSetup& edited = m_controller.setup().edited();
    bool isPlace = status && table && m_applied->isOfDrive()
        && table->grid.dimensions() == edited.dimensionality;
    for (std::size_t n = 0; isPlace && n < table->grid.axes.size(); ++n) {
        const DimSource& source = status->setup.sources.at(n);
        isPlace = source.isSet() && source == edited.sources.at(n);
    }
    const auto marker = isPlace
        ? std::optional(TablePlot::Marker{status->sourceValues, status->output})
        : std::nullopt;
    m_plot->setMarker(marker);
    m_surface->setMarker(marker);
    m_vectors->setMarker(marker ? vectorPlace(marker->positions) : std::nullopt);
    const auto& proof = m_controller.movingProof();
    m_plot->setProved(proof && m_applied->isOfDrive() ? &proof->part() : nullptr);
}

/// Of the axes whose positions are the sources, as far as the drive says it.
void PreviewPanel::showTravel()
{
    std::array<std::optional<Travel>, 3> travel;
    const auto table = m_controller.selectedTable();
    const auto& axes = m_controller.axes();
    const auto current = static_cast<std::size_t>(m_controller.currentAxis());
    if (table && m_controller.status() && current < axes.size()) {
        const auto travelOf = [&](int axis) -> Result<std::optional<Travel>> {
            if (axis == m_controller.status()->axis.index)
                return m_controller.status()->axis.travel;
            for (const AxisEntry& entry : axes)
                if (entry.axis.index == axis && entry.endpoint == axes[current].endpoint)
                    return entry.axis.travel;
            return std::nullopt;
        };
        const auto coverage =
            travelCoverage(m_profile, m_controller.setup().edited().sources, table->grid, travelOf);
        if (coverage)
            for (const DimensionCoverage& dimension : *coverage)
                travel.at(dimension.dimension) = dimension.travel;
    }
    m_plot->setTravel(travel, m_applied->isOfDrive());
}

/// Positions of the drive in the units of the open file.
std::optional<std::array<double, 3>> PreviewPanel::vectorPlace(
    std::array<double, 3> positions) const
{
    const auto& file = m_controller.dataFile().data;
    const auto table = m_controller.selectedTable();
    if (!file || !table || file->grid.dimensions() != table->grid.dimensions())
        return std::nullopt;
    for (std::size_t n = 0; n < table->grid.axes.size(); ++n)
        positions.at(n) *=
            unitFactor(table->grid.axes[n].unit, file->grid.axes[n].unit).value_or(1.0);
    return positions;
}

void PreviewPanel::showFacts()
{
    const bool hasTable = m_controller.selectedTable() != nullptr;
    m_facts->setText(hasTable ? m_shown->description() : QString());
    m_size->setText(hasTable ? sizeText() : QString());
    const QString warnings = warningText();
    m_warnings->setText(warnings);
    m_warnings->setVisible(!warnings.isEmpty());
    const QString sign = m_controller.signSentence();
    m_sign->setText(sign);
    m_sign->setVisible(!sign.isEmpty());
}

QString PreviewPanel::sizeText() const
{
    const std::size_t bytes = m_controller.selectedTableBytes();
    const auto& setup = m_controller.setup();
    const TableSlot* slot = setup.edited().table.fileTable
        ? smallestSlot(m_profile, bytes)
        : m_profile.slotNamed(setup.baseline().slot);
    if (!slot)
        return tr("%1 bytes, more than any slot of the drive holds").arg(countText(bytes));
    return tr("%1 of %2 bytes of a table slot").arg(countText(bytes), countText(slot->maximumSize));
}

QString PreviewPanel::warningText() const
{
    if (!m_applied->problem().isEmpty())
        return QStringLiteral("⚠ ") + m_applied->problem();
    if (!m_controller.setup().edited().table.fileTable)
        return {};
    QStringList lines;
    for (const Diagnostic& problem : m_controller.dataFile().problems) {
        if (problem.severity == Severity::Warning)
            lines += QStringLiteral("⚠ ") + problemText(problem);
    }
    constexpr qsizetype mostLines = 2;
    if (lines.size() > mostLines) {
        const qsizetype more = lines.size() - mostLines;
        lines = lines.mid(0, mostLines);
        lines.last() += QStringLiteral("  (+%1)").arg(more);
    }
    return lines.join(u'\n');
}

void PreviewPanel::showProblems()
{
    const DataFile& file = m_controller.dataFile();
    if (file.isReading)
        return;
    const bool hasErrors = std::ranges::any_of(file.problems,
        [](const Diagnostic& problem) { return problem.severity == Severity::Error; });
    const int index = m_tabs->indexOf(m_problems);
    if (m_problems->setProblems(file))
        m_valuesStack->setCurrentWidget(m_values);
    if (file.problems.empty()) {
        if (index >= 0)
            m_tabs->removeTab(index);
        m_problems->setVisible(false);
        return;
    }
    const QString title =
        tr("Problems (%1)").arg(countText(file.problems.size() + file.suppressedProblems));
    if (index < 0)
        m_tabs->addTab(m_problems, title);
    else
        m_tabs->setTabText(index, title);
    if (hasErrors)
        m_tabs->setCurrentWidget(m_problems);
}

} // namespace axiscomp::ui
