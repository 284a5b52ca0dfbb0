#pragma once
/// The UM-Bridge 1.0 protocol (Seelinger et al. 2023, J. Open Source Softw. 8(83), 4748)
/// without its transport: requests and answers are JSON texts.

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace app {

struct ServedColumn {
    std::string name, unit, meaning;
};

/// One vector in, one vector out. It can be evaluated, and has no derivatives.
struct ServedModel {
    std::string name;
    std::vector<ServedColumn> inputs, outputs; ///< one number each; at least one
    /// Called from any thread.
    /// @param x one number per input, finite
    /// @return one number per output, finite
    /// @throws BadValue (app/input/study/units.hpp) if x is not an input of the model,
    /// std::runtime_error if there is no answer
    std::function<std::vector<double>(std::span<const double> x)> evaluate;
};

struct HttpReply {
    int status = 200; ///< 400: the request is wrong, 500: it is right and has no answer
    std::string body; ///< JSON
};

/// The paths that are answered with POST; "/Info" is answered with GET. "/Columns" is ours:
/// names and units of a model's numbers, for which the protocol has no place.
inline constexpr const char* kUmbridgePaths[] = {
    "/ModelInfo", "/InputSizes",    "/OutputSizes",  "/Evaluate",
    "/Gradient",  "/ApplyJacobian", "/ApplyHessian", "/Columns"};

[[nodiscard]] HttpReply umbridge_info(std::span<const ServedModel> models);

/// @param path one of kUmbridgePaths
/// @param body any bytes. Never throws for what they are.
[[nodiscard]] HttpReply umbridge_reply(std::span<const ServedModel> models,
                                       std::string_view path, const std::string& body);

/// @param type "InvalidInput", "ModelNotFound", ...
[[nodiscard]] HttpReply umbridge_error(int status, std::string_view type,
                                       const std::string& message);

} // namespace app
