#include "app/study/answers/mode_share.hpp"

namespace app {

fragility::Share mode_share(const StudyLevel& level, int mode, double confidence,
                            core::BinomialInterval kind)
{
    return fragility::share(static_cast<double>(walls_of(level, mode).size()),
                            static_cast<double>(level.walls.size()),
                            static_cast<double>(level.failed_walls.size()), kind, confidence);
}

} // namespace app
