#pragma once

namespace wavecurve::io {

/// The text of player.html, in which {{title}} and {{data}} are to be replaced.
extern const char* const player_page;

}  // namespace wavecurve::io
