/// drystone VERB STUDY.ini [options].  Exit codes: 0 done, 1 failed, 2 your input, 130 told to
/// end.

#include "app/input/command_line.hpp"
#include "app/store/hdf5/store_error.hpp"
#include "app/study/pushed/interrupt.hpp"
#include "app/text/config_error.hpp"
#include "app/verbs.hpp"

#include <csignal>
#include <exception>
#include <iostream>
#include <stdexcept>

int main(int argc, char** argv)
{
    // A full disk, a limit of file size or a closed pipe is an error with a message, not a
    // death.
    for (const int signal : {SIGXFSZ, SIGPIPE}) std::signal(signal, SIG_IGN);
    app::end_at_ctrl_c();
    try {
        const app::Command command =
            app::parse_command_line(app::verbs(), {argv + 1, argv + argc});
        const int code = command.verb->run(command);
        if (!std::cout.flush()) throw std::runtime_error("cannot write to standard output");
        return code;
    } catch (const app::Interrupted& i) {
        std::cerr << "drystone: interrupted; " << i.kept << '\n';
        return app::kInterruptedCode;
    } catch (const app::ConfigError& e) {
        std::cerr << e.what() << '\n';
        return 2;
    } catch (const app::BadStoredStudy& e) {
        std::cerr << "drystone: " << e.what() << '\n';
        return 2;
    } catch (const std::exception& e) {
        std::cerr << "drystone: " << e.what() << '\n';
        return 1;
    }
}
