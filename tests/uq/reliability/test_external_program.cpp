#include "uq/reliability/limit_state/external_program.hpp"

#include "tests/scenes/temporary_folder.hpp"
#include "tests/uq/reliability/reliability_problems.hpp"
#include "uq/reliability/limit_state/evaluate.hpp"

#include <catch2/catch.hpp>

#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <thread>

using namespace uq;
namespace fs = std::filesystem;
using scenes::TemporaryFolder;

namespace {

/// Runs `script` by sh; $1 is the input, $2 the result file. Two parameters a, b; one response
/// s.
ExternalProgram shell(const TemporaryFolder& scratch, const std::string& script)
{
    ExternalProgram p;
    p.command = {"sh", "-c", script, "sh", "{input}", "{output}"};
    p.parameters = {"a", "b"};
    p.responses = {"s"};
    p.directory = scratch.path / "runs";
    return p;
}

Samples samples(Eigen::Index n)
{
    Samples s{Eigen::MatrixXd(n, 2), {}};
    for (Eigen::Index i = 0; i < n; ++i) {
        s.x.row(i) << static_cast<double>(i), 0.1;
        s.id.push_back(static_cast<std::uint64_t>(10 + i));
    }
    return s;
}

std::string reason(const ExternalProgram& p)
{
    const Responses r = external_model(p)(samples(1));
    CHECK(std::isnan(r.y(0, 0)));
    return r.failure[0];
}

bool has(const std::string& text, const std::string& part)
{
    INFO(text << " / " << part);
    CHECK(text.find(part) != std::string::npos);
    return true;
}

/// awk reads {"sample": .., "parameters": {"a": .., "b": ..}} and writes a + 10 b.
const std::string kSum =
    "awk -F'[:,]' '/\"a\"/{a=$2} /\"b\"/{b=$2} "
    "END{printf \"{\\\"responses\\\": {\\\"s\\\": %.17g}}\", a+10*b}' $1 > $2";

double seconds_since(std::chrono::steady_clock::time_point start)
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

} // namespace

TEST_CASE("external program: results come back by sample, whatever the number at a time",
          "[uq][external_program]")
{
    const TemporaryFolder scratch;
    // Later samples are quicker, so that they end in another order than they began.
    ExternalProgram p = shell(scratch, "sleep 0.0$((9 - DRYSTONE_SAMPLE % 10)); " + kSum);
    p.concurrent = GENERATE(1, 3, 50);
    const Responses r = external_model(p)(samples(8));
    for (Eigen::Index i = 0; i < 8; ++i) {
        CHECK(r.failure[static_cast<std::size_t>(i)].empty());
        CHECK(r.y(i, 0) == static_cast<double>(i) + 1.0);
    }
    CHECK(fs::is_empty(p.directory));
}

TEST_CASE("external program: several run at a time", "[uq][external_program]")
{
    const TemporaryFolder scratch;
    // Each waits until all eight have begun.
    const std::string begun = (scratch.path / "begun").string();
    ExternalProgram p = shell(scratch, "echo >>" + begun + "; while test $(wc -l <" + begun +
                                           ") -lt 8; do sleep 0.01; done; " + kSum);
    p.concurrent = 8;
    p.time_limit = 30;
    CHECK(problems::count_failed(external_model(p)(samples(8))) == 0);
}

TEST_CASE("external program: numbers reach it and come back to the bit",
          "[uq][external_program]")
{
    const TemporaryFolder scratch;
    ExternalProgram p = shell(scratch, "");
    // Standard input and output instead of files; the parameters returned as responses.
    p.command = {"sed", "s/\"parameters\"/\"responses\"/"};
    p.responses = {"b", "a"};
    Samples s = samples(1);
    s.x << 0.1 + 0.2, -5e-324;
    const Responses r = external_model(p)(s);
    CHECK(r.failure[0].empty());
    CHECK(r.y(0, 0) == s.x(0, 1));
    CHECK(r.y(0, 1) == s.x(0, 0));
}

TEST_CASE("external program: each way to fail has its own reason", "[uq][external_program]")
{
    const TemporaryFolder scratch;
    const auto says = [&](const std::string& script, const std::string& part) {
        return has(reason(shell(scratch, script)), part);
    };
    says("echo one >&2; echo two >&2; exit 3", "exit code 3; stderr: one | two");
    says("printf 'a\\033[31m\\377b' >&2; exit 3",
         "exit code 3; stderr: a [31m\xEF\xBF\xBD"
         "b"); // no escapes, nothing but UTF-8
    says("kill -SEGV $$", "signal 11 (Segmentation fault)");
    says("true", "there is no result file");
    says(": > $2", "the result is empty");
    says("printf '{\"responses\": {\"s\": 1.' > $2", "ends too early (half-written?)");
    says("printf '{\"responses\": {\"s\"' > $2", "ends too early (half-written?)");
    says("echo 'Segmentation fault' > $2", "result is not JSON, from byte 1");
    says("echo '{\"responses\": {\"s\": NaN}}' > $2", "holds NaN or infinity");
    says("echo '{\"responses\": {\"s\": -Infinity}}' > $2", "holds NaN or infinity");
    says("echo '{\"responses\": {\"s\": 1e999}}' > $2", "too large");
    says("echo '{\"responses\": {\"s\": 1}, \"responses\": {\"s\": 9}}' > $2",
         "result names \"responses\" twice");
    says("echo '{\"responses\": {\"s\": 1, \"s\": 9}}' > $2", "result names \"s\" twice");
    says("echo '{\"responses\": {\"s\": null}}' > $2", "response \"s\" is null, not a number");
    says("echo '{\"responses\": {\"s\": \"12\"}}' > $2", "response \"s\" is text (\"12\")");
    says("echo '{\"responses\": {\"s\": [1]}}' > $2", "response \"s\" is of type array");
    says("echo '{\"responses\": {\"t\": 1}}' > $2", "response \"s\" is missing");
    says("echo '{\"s\": 1}' > $2", "no object \"responses\"");
    says("echo '[1]' > $2", "not a JSON object");
    says("echo '{\"failure\": \"no equilibrium\"}' > $2", "the program says: no equilibrium");
    ExternalProgram p = shell(scratch, "");
    p.command = {"/no/such/program"};
    has(reason(p), "cannot run /no/such/program: No such file or directory");
    Samples s = samples(1);
    s.x(0, 0) = std::nan("");
    CHECK(external_model(shell(scratch, kSum))(s).failure[0] ==
          "a parameter is not finite: not run");
}

TEST_CASE("external program: only the last lines of stderr are kept", "[uq][external_program]")
{
    const TemporaryFolder scratch;
    ExternalProgram p = shell(scratch, "seq 100 >&2; exit 1");
    p.stderr_lines = 2;
    CHECK(reason(p) == "exit code 1; stderr: 99 | 100");
    p.stderr_lines = 0;
    CHECK(reason(p) == "exit code 1");
}

TEST_CASE("external program: one that hangs is stopped at its time limit, the others are not",
          "[uq][external_program]")
{
    const TemporaryFolder scratch;
    ExternalProgram p = shell(scratch, "test $DRYSTONE_SAMPLE = 11 && sleep 60; " + kSum);
    p.time_limit = 3; // the others need some milliseconds, seconds on a machine with much to do
    p.concurrent = 2;
    const auto start = std::chrono::steady_clock::now();
    const Responses r = external_model(p)(samples(4));
    CHECK(seconds_since(start) < 30);
    CHECK(r.failure[1] == "no answer within 3.0 s, stopped");
    CHECK(problems::count_failed(r) == 1);
}

TEST_CASE("external program: one that ignores SIGTERM is killed after its grace",
          "[uq][external_program]")
{
    const TemporaryFolder scratch;
    ExternalProgram p = shell(scratch, "trap '' TERM; while :; do sleep 0.05; done");
    p.time_limit = 2; // until then it has set its trap
    p.grace = 0.3;
    const auto start = std::chrono::steady_clock::now();
    CHECK(reason(p) == "no answer within 2.0 s, killed");
    CHECK(seconds_since(start) >= 2.3);
    CHECK(seconds_since(start) < 30);
}

TEST_CASE("external program: what it has started dies with it", "[uq][external_program]")
{
    const TemporaryFolder scratch;
    const std::string pid_file = (scratch.path / "pid").string();
    const bool hangs = GENERATE(true, false);
    // A grandchild that ignores SIGTERM and writes its number.
    ExternalProgram p =
        shell(scratch, "(trap '' TERM; sleep 60 & echo $! > " + pid_file +
                           "; wait) & while ! test -s " + pid_file + "; do sleep 0.01; done; " +
                           (hangs ? "sleep 60" : kSum));
    p.time_limit = hangs ? 3 : 0; // until then the number is written
    p.grace = 0.2;
    const Responses r = external_model(p)(samples(1));
    CHECK(r.failure[0].empty() != hangs);
    pid_t grandchild = 0;
    std::ifstream(pid_file) >> grandchild;
    REQUIRE(grandchild > 1);
    bool alive = true;
    for (int i = 0; i < 2000 && alive; ++i) { // killed; its new parent has yet to reap it
        std::ifstream stat("/proc/" + std::to_string(grandchild) + "/stat");
        std::string id, name, state;
        alive = static_cast<bool>(stat >> id >> name >> state) && state != "Z";
        if (alive) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    CHECK_FALSE(alive);
}

TEST_CASE("external program: a run that failed is tried again, as often as allowed",
          "[uq][external_program]")
{
    const TemporaryFolder scratch;
    ExternalProgram p = shell(scratch, "test $DRYSTONE_TRY = 2 || exit 9; " + kSum);
    CHECK(reason(p) == "exit code 9");
    p.retries = 1;
    CHECK(external_model(p)(samples(1)).y(0, 0) == 1.0);
    ExternalProgram never = shell(scratch, "exit 9");
    never.retries = 2;
    CHECK(reason(never) == "try 3: exit code 9");
}

TEST_CASE("external program: a failure by its own account is not tried again",
          "[uq][external_program]")
{
    const TemporaryFolder scratch;
    const std::string count = (scratch.path / "count").string();
    ExternalProgram p =
        shell(scratch, "echo x >> " + count + "; echo '{\"failure\": \"f\"}' > $2");
    p.retries = 5;
    CHECK(reason(p) == "the program says: f");
    CHECK(fs::file_size(count) == 2);
}

TEST_CASE("external program: directories of failed runs can be kept", "[uq][external_program]")
{
    const TemporaryFolder scratch;
    ExternalProgram p = shell(scratch, "test $DRYSTONE_SAMPLE = 11 && exit 1; " + kSum);
    p.keep = Keep::failed;
    const Responses r = external_model(p)(samples(3));
    const std::size_t at = r.failure[1].find("; kept in ");
    REQUIRE(at != std::string::npos);
    CHECK(fs::exists(fs::path(r.failure[1].substr(at + 10)) / "input.json"));
    const auto runs = *fs::directory_iterator(p.directory);
    CHECK(std::distance(fs::directory_iterator(runs), {}) == 1);
}

TEST_CASE("external program: placeholders and environment are filled in",
          "[uq][external_program]")
{
    const TemporaryFolder scratch;
    ExternalProgram p = shell(scratch, "");
    p.environment = {{"WEIGHT", "7"}};
    p.command = {"sh", "-c",
                 "test \"$PWD\" = {directory} && test \"$1\" = x{sample}x && test -d {here} && "
                 "echo \"{\\\"responses\\\": {\\\"s\\\": $WEIGHT}}\"",
                 "sh", "x{sample}x"};
    const Responses r = external_model(p)(samples(1));
    CHECK(r.failure[0] == "");
    CHECK(r.y(0, 0) == 7.0);
}

TEST_CASE("external program: what cannot be run is refused", "[uq][external_program]")
{
    const TemporaryFolder scratch;
    const ExternalProgram good = shell(scratch, "true");
    const auto refused = [&](auto change) {
        ExternalProgram p = good;
        change(p);
        CHECK_THROWS_AS(external_model(p), std::invalid_argument);
    };
    refused([](ExternalProgram& p) { p.command.clear(); });
    refused([](ExternalProgram& p) { p.responses.clear(); });
    refused([](ExternalProgram& p) { p.parameters = {"a", "a"}; });
    refused([](ExternalProgram& p) { p.parameters = {"a", ""}; });
    refused([](ExternalProgram& p) { p.concurrent = 0; });
    refused([](ExternalProgram& p) { p.retries = -1; });
    refused([](ExternalProgram& p) { p.time_limit = -1.0; });
    refused([](ExternalProgram& p) { p.grace = std::nan(""); });
    const Samples wide{Eigen::MatrixXd::Zero(1, 3), {0}};
    CHECK_THROWS_AS(external_model(good)(wide), std::invalid_argument);
}

TEST_CASE("external program: a pipe, a device or a folder in place of the result is no result",
          "[uq][external_program]")
{
    const TemporaryFolder scratch;
    const char* script = GENERATE("mkfifo $2", "ln -s /dev/zero $2", "mkdir $2");
    const Responses r = external_model(shell(scratch, script))(samples(1));
    CHECK(r.failure[0].find("the result is not a regular file") == 0);
    CHECK(fs::is_empty(scratch.path / "runs"));
}

TEST_CASE("external program: a pipe in place of stderr does not stop the answer",
          "[uq][external_program]")
{
    const TemporaryFolder scratch;
    const Responses r =
        external_model(shell(scratch, "rm stderr; mkfifo stderr; exit 3"))(samples(1));
    CHECK(r.failure[0] == "exit code 3");
}

TEST_CASE("external program: deep brackets and large results are refused",
          "[uq][external_program]")
{
    const TemporaryFolder scratch;
    const Responses deep = external_model(shell(
        scratch, "(printf '{\"failure\": '; head -c 100000 /dev/zero | tr '\\0' '['; "
                 "head -c 100000 /dev/zero | tr '\\0' ']'; printf '}') > $2"))(samples(1));
    CHECK(deep.failure[0].find("the brackets of the result are more than 100 deep") == 0);
    const Responses large =
        external_model(shell(scratch, "head -c 20000000 /dev/zero > $2"))(samples(1));
    CHECK(large.failure[0].find("the result is larger than 16 MiB") == 0);
}

TEST_CASE("external program: what is thrown while waiting ends the runs and removes their "
          "folders",
          "[uq][external_program]")
{
    struct Stop {};
    const TemporaryFolder scratch;
    const fs::path number = scratch.path / "pid";
    ExternalProgram p = shell(scratch, "sleep 100 & echo $! > " + number.string() + "; wait");
    p.while_waiting = [&] {
        if (fs::exists(number) && fs::file_size(number) > 0) throw Stop();
    };
    CHECK_THROWS_AS(external_model(p)(samples(1)), Stop);
    int child = 0;
    std::ifstream(number) >> child;
    REQUIRE(child > 0);
    for (int i = 0; i < 500 && kill(child, 0) == 0; ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    CHECK(kill(child, 0) != 0); // also what the run had started
    CHECK(fs::is_empty(scratch.path / "runs"));
}

TEST_CASE("external program: a time limit beyond what a clock holds is no limit",
          "[uq][external_program]")
{
    const TemporaryFolder scratch;
    ExternalProgram p = shell(scratch, "echo '{\"responses\": {\"s\": 1}}' > $2");
    p.time_limit = 1e12;
    CHECK(external_model(p)(samples(1)).failure[0].empty());
}
