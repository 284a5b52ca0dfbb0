#pragma once
/// Defaults of where a push ends: with finite displacements it goes on until the limit states
/// that a study asks for are decided.

namespace app {

struct Key;
struct Study;

/// load.max_displacement of a finite push one way: a fifth of load.height. A wall as high as it
/// is long that turns about its toe is down to 80 % of its peak at a tenth of its height.
void derive_push_end(Study& study);

/// load.stop_below of a finite push one way: 0.02 below the least share of the peak that a
/// limit state asks for; 0 where one asks for the end, or for the last fall below a share.
void derive_stop_below(Study& study);

/// output.snapshot_every of a finite push one way: a hundred pictures of the way or fewer, not
/// closer than 0.5 mm.
void derive_snapshots(Study& study);

/// Whether a key has one of these defaults. A file of results gives them as numbers: its walls
/// were pushed so far, whatever is asked for later.
[[nodiscard]] bool says_push_end(const Key& key);

} // namespace app
