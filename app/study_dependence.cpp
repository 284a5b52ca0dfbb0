#include "app/study_dependence.hpp"

namespace app {

Eigen::MatrixXd mixing_of(const Study&) { return {}; }

} // namespace app
