#include "app/serve/umbridge.hpp"

#include "app/input/study/units.hpp"
#include "app/text/json_text.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace app {
namespace {

HttpReply reply_of(const Json& json) { return {200, text_of(json)}; }

HttpReply invalid(const std::string& why) { return umbridge_error(400, "InvalidInput", why); }

Json columns_json(std::span<const ServedColumn> columns)
{
    Json list = Json::array();
    for (const ServedColumn& c : columns)
        list.push_back({{"name", c.name}, {"unit", c.unit}, {"meaning", c.meaning}});
    return list;
}

Json model_columns(const ServedModel& model)
{
    return {{"inputs", columns_json(model.inputs)}, {"outputs", columns_json(model.outputs)}};
}

Json model_info()
{
    return {{"support",
             {{"Evaluate", true},
              {"Gradient", false},
              {"ApplyJacobian", false},
              {"ApplyHessian", false}}}};
}

/// [[1, 2, 3]] as numbers. @throws BadValue
std::vector<double> input_of(const Json& request, const ServedModel& model)
{
    const std::string wanted = "must be one vector of " + std::to_string(model.inputs.size()) +
                               " numbers, [[x1, x2, ...]]";
    const auto input = request.find("input");
    if (input == request.end()) throw BadValue("input: missing; " + wanted);
    const bool one = input->is_array() && input->size() == 1 && input->front().is_array();
    if (!one || input->front().size() != model.inputs.size())
        throw BadValue("input: " + wanted);
    std::vector<double> x;
    for (const Json& number : input->front()) {
        if (!number.is_number()) throw BadValue("input: " + wanted);
        x.push_back(number.get<double>());
    }
    return x;
}

void check_config(const Json& request)
{
    const auto config = request.find("config");
    if (config == request.end()) return;
    if (!config->is_object()) throw BadValue("config: must be an object, {}");
    if (!config->empty())
        throw BadValue("config: this model has none; start the server with --set instead of " +
                       config->begin().key());
}

HttpReply evaluate(const Json& request, const ServedModel& model)
{
    try {
        check_config(request);
        const std::vector<double> y = model.evaluate(input_of(request, model));
        const bool whole = y.size() == model.outputs.size() &&
                           std::ranges::all_of(y, [](double v) { return std::isfinite(v); });
        if (!whole) throw std::runtime_error("an output is not a number");
        return reply_of({{"output", Json::array({y})}});
    } catch (const BadValue& bad) {
        return invalid(bad.what());
    } catch (const std::exception& e) {
        return umbridge_error(500, "InvalidOutput", e.what());
    }
}

HttpReply reply(const ServedModel& model, std::string_view path, const Json& request)
{
    if (path == "/ModelInfo") return reply_of(model_info());
    if (path == "/Columns") return reply_of(model_columns(model));
    if (path == "/InputSizes")
        return reply_of({{"inputSizes", Json::array({model.inputs.size()})}});
    if (path == "/OutputSizes")
        return reply_of({{"outputSizes", Json::array({model.outputs.size()})}});
    if (path == "/Evaluate") return evaluate(request, model);
    return umbridge_error(400, "UnsupportedFeature",
                          std::string(path.substr(1)) + ": this model has no derivatives");
}

} // namespace

HttpReply umbridge_error(int status, std::string_view type, const std::string& message)
{
    HttpReply error = reply_of({{"error", {{"type", type}, {"message", message}}}});
    error.status = status;
    return error;
}

HttpReply umbridge_info(std::span<const ServedModel> models)
{
    Json names = Json::array();
    for (const ServedModel& model : models) names.push_back(model.name);
    return reply_of({{"protocolVersion", 1.0}, {"models", names}});
}

HttpReply umbridge_reply(std::span<const ServedModel> models, std::string_view path,
                         const std::string& body)
{
    Json request;
    try {
        request = json_of(body);
    } catch (const Json::exception&) {
        return invalid("the request is not JSON");
    }
    if (!request.is_object()) return invalid("the request is not a JSON object");
    const auto name = request.find("name");
    if (name == request.end() || !name->is_string())
        return invalid("name: missing; must be the name of a model, as /Info lists them");
    const auto model = std::ranges::find(models, name->get<std::string>(), &ServedModel::name);
    if (model == models.end())
        return umbridge_error(400, "ModelNotFound",
                              "name: no such model; /Info lists those there are");
    return reply(*model, path, request);
}

} // namespace app
