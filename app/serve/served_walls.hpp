#pragma once
/// The walls of a study as models of UM-Bridge: numbers of one wall in, numbers read off its
/// push out, all in SI.

#include "app/input/command.hpp"
#include "app/input/prepared_study.hpp"
#include "app/serve/umbridge.hpp"
#include "app/study/pushed/pushed_wall.hpp"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace app {

/// Pushes one wall; waits for it.
using WallPush = std::function<PushedWall(WantedWall)>;

/// A study whose random variables are the inputs of the server.
struct ServedStudy {
    PreparedStudy ready;
    bool distributions = false; ///< each input has one, with coordinates
};

/// @param inputs keys; the others keep their numbers, or the means of their distributions.
/// Empty: the random variables
/// of the study
/// @throws ConfigError if there is none, or one cannot be an input
[[nodiscard]] ServedStudy served_study(const PreparedStudy& ready,
                                       const std::vector<std::string>& inputs);

/// Name of a model under one of the stresses of a study; with several of them it becomes
/// NAME_0.50_MPa.
[[nodiscard]] std::string served_name(const std::string& study, std::size_t stresses,
                                      double stress);

/// Under each vertical stress the model NAME_normal, whose inputs are standard normal
/// coordinates of the study's distributions, and the model NAME, whose inputs are the values
/// themselves in SI, refused outside the range of their key. NAME_normal comes first: a client
/// that knows nothing of a model sends zeros, which are its medians.
/// @param name of the study, as served_name() takes it
/// @param responses names of outputs, at least one
/// @throws ConfigError if a response is unknown
[[nodiscard]] std::vector<ServedModel> served_models(const ServedStudy& study,
                                                     const std::string& name,
                                                     const std::vector<std::string>& responses,
                                                     const WallPush& push);

} // namespace app
