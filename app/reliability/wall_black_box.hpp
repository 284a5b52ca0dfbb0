#pragma once
/// The wall of a study as a black box: random values in, responses out.

#include "app/input/prepared_study.hpp"
#include "app/sampling/sample_plan.hpp"
#include "dem/scene/layout.hpp"
#include "uq/reliability/limit_state/black_box.hpp"
#include "uq/reliability/limit_state/limit_state.hpp"

#include <string>

namespace app {

struct RandomInput;
struct StudyFile;

/// @param or_else what else can be done, at the end of the message
/// @throws ConfigError if no value of the study is a distribution
void check_random(const std::vector<RandomInput>& random, const StudyFile& source,
                  const std::string& or_else = "");

/// How any wall of the study is drawn, by whoever draws the samples.
[[nodiscard]] SamplePlan any_wall_plan(Study study, const dem::Layout& layout);

/// Columns of the answer, in SI: the first kJudged of kWallNumbers. Where the force never falls
/// to the ultimate share of the peak, the ultimate displacement is the end of the push: a
/// bound, good for demands below it.
/// @param level index in study.load.vertical_stress
/// @param threads >= 1
[[nodiscard]] uq::BlackBox wall_model(const PreparedStudy& ready, const SamplePlan& plan,
                                      int level, int threads);

/// Standard normal coordinates to the values of a wall.
/// @throws ConfigError with Spatial::stratified, whose draws have no coordinates
[[nodiscard]] uq::Map wall_map(const StudyFile& source, const SamplePlan& plan);

} // namespace app
