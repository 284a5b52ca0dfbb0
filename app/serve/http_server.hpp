#pragma once
/// HTTP for umbridge.hpp. The only file that knows the HTTP library is http_server.cpp.

#include "app/serve/umbridge.hpp"

#include <cstddef>
#include <functional>
#include <span>
#include <string>

namespace app {

struct HttpOptions {
    std::string address = "127.0.0.1"; ///< of this machine, at which it listens
    int port = 4242;                   ///< 0: any free one
    /// Of a request [byte]. A wall with ten thousand joints has half a million.
    std::size_t most_bytes = 8 << 20;
    double most_seconds = 10.0; ///< in which the body of a request has to arrive [s]
    int silent_seconds = 5;     ///< so long a connection may be silent within a request [s]
    int connections = 128;      ///< served at a time; further ones wait
};

/// Answers until `ended` says so. Requests outside the limits get an error in JSON.
/// @param listening is told the port
/// @param ended is asked every tenth of a second
/// @throws std::runtime_error if it cannot listen there
void serve_http(const HttpOptions& options, std::span<const ServedModel> models,
                const std::function<void(int port)>& listening,
                const std::function<bool()>& ended);

} // namespace app
