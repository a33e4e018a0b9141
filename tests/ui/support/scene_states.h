// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/ui/support/page_scene.h"

#include <functional>
#include <vector>

namespace axiscomp::test {

/// A state of the page or of one of its dialogs, for a person to look at.
struct SceneState {
    const char* name;
    std::function<void(PageScene&)> make;
    bool isHomed = true;
};
[[nodiscard]] const std::vector<SceneState>& sceneStates();

/// The page, or the dialog that is open on it.
[[nodiscard]] QWidget& shownWindow(PageScene& scene);

/// Sizes of screens, in the units that widgets are laid out in: a laptop's, that of a projector,
/// and 1920 x 1080 at twice the size.
struct ScreenSize {
    QSize size;
    int scale = 1;
};
inline constexpr std::array screenSizes{
    ScreenSize{QSize(1366, 768)}, ScreenSize{QSize(1280, 720)}, ScreenSize{QSize(960, 540), 2}};

/// As large as the state likes it, but not larger than the screen.
inline void fitTo(QWidget& window, const QSize& screen, bool isPage)
{
    window.resize(isPage ? screen : window.size().boundedTo(screen));
}

} // namespace axiscomp::test
