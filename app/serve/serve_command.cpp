#include "app/commands.hpp"
#include "app/input/study_reading.hpp"

#include "app/input/key_effects.hpp"
#include "app/output/picture/markup.hpp"
#include "app/serve/http_server.hpp"
#include "app/serve/served_surrogate.hpp"
#include "app/serve/served_walls.hpp"
#include "app/serve/wall_queue.hpp"
#include "app/study/pushed/interrupt.hpp"
#include "app/text/config_error.hpp"
#include "dem/block/model.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>
#include <memory>

namespace app {
namespace {

/// Requests of walls that are asked for while the others are pushed wait here.
constexpr int kConnectionsPerThread = 64; // choice: four times the lanes of the widest register

std::string machine_name()
{
    std::array<char, 256> name{};
    return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

void list(const char* what, const std::vector<ServedColumn>& columns)
{
    constexpr std::size_t kShown = 8;
    std::cout << "  " << what << ": ";
    for (std::size_t i = 0; i < columns.size() && i < kShown; ++i)
        std::cout << (i > 0 ? ", " : "") << columns[i].name << " [" << columns[i].unit << "]";
    if (columns.size() > kShown) std::cout << ", ... (" << columns.size() << ")";
    std::cout << '\n';
}

void say(const HttpOptions& options, int port, const std::vector<ServedModel>& models)
{
    std::cout << "UM-Bridge at http://" << options.names.address << ":" << port
              << ", until Ctrl-C\n";
    for (const ServedModel& model : models) {
        std::cout << model.name << '\n';
        list("in", model.inputs);
        list("out", model.outputs);
    }
    std::cout.flush();
    if (!is_loopback(options.names.address))
        std::cerr << "drystone: anyone who can reach " << options.names.address
                  << " can push walls here; there is no password\n";
}

void serve(const Command& command, const std::vector<ServedModel>& models)
{
    HttpOptions options;
    options.names = {command.address, machine_name(), command.hosts};
    options.port = command.port;
    options.connections =
        std::max(options.connections, kConnectionsPerThread * command.threads);
    serve_http(
        options, models, [&](int port) { say(options, port, models); }, interrupted);
}

/// Options of walls alone are refused.
void serve_surrogate(const Command& command)
{
    const auto refuse = [](bool given, const char* option) {
        if (given)
            throw ConfigError("drystone", 0, option,
                              "a surrogate is served as it was learned; leave it out, or give "
                              "the study file");
    };
    refuse(!command.overrides.empty(), "--set");
    refuse(!command.inputs.empty(), "--input");
    refuse(!command.responses.empty(), "--response");
    const auto surrogate =
        std::make_shared<const LearnedSurrogate>(read_surrogate(command.study));
    const std::vector<ServedModel> models = surrogate_models(surrogate);
    std::cerr << wrapped(surrogate_doubts(*surrogate), terminal_width());
    catch_interrupts();
    serve(command, models);
}

} // namespace

int serve_command(const Command& command)
{
    if (is_surrogate_file(command.study)) {
        serve_surrogate(command);
        return 0;
    }
    const PreparedStudy given = prepare(read_study(command.study, command.overrides));
    const ServedStudy served = served_study(given, command.inputs);
    std::cerr << study_notes(given, command.verb);
    const dem::Model model = model_of(served.ready);
    catch_interrupts();
    WallQueue queue(served.ready.study, model, command.threads);
    serve(command,
          served_models(served, std::filesystem::path(command.study).stem().string(),
                        command.responses.empty() ? std::vector<std::string>{"peak_force"}
                                                  : command.responses,
                        [&](WantedWall wall) { return queue.push(std::move(wall)); }));
    return 0;
}

} // namespace app
