#pragma once
/// One line that says how far the walls of a push are, and why one of them begins again.

#include "app/output/progress.hpp"
#include "dem/solver/push.hpp"

#include <iosfwd>
#include <string>
#include <vector>

namespace app {

/// The line is of all walls together; its text is of the wall that spoke last. A push that
/// begins again has cost what it has done, and is work anew: twice as much where it goes half
/// as fast. Not thread-safe.
class PushLine {
  public:
    /// @param walls names them: "1.25 MPa"; said only where there are several
    /// @param accuracy that is asked for [-]
    PushLine(std::vector<std::string> walls, double accuracy, std::ostream& out,
             ProgressOptions options, Progress::Clock clock);

    void update(const dem::PushProgress& p);
    /// The wall is done.
    void end(std::size_t wall);
    void finish();

  private:
    /// Work of one wall, in pushes at the first speed.
    struct Work {
        double before = 0.0; ///< by pushes that were given up
        double cost = 1.0;   ///< of the push that runs
        double done = 0.0;   ///< share of it, in [0, 1]
        dem::PushProgress last;
    };
    void begin_again(Work& work, const dem::PushProgress& p);

    std::vector<std::string> names_;
    double accuracy_;
    std::vector<Work> work_;
    Progress line_;
};

} // namespace app
