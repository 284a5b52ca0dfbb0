#pragma once
/// Which requests a server answers, by their heads: a web page that a user happens to look at
/// must not push walls, nor read what the server says.

#include "app/serve/umbridge.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace app {

/// Headers of one request that decide whether it is read, each as often as it was sent.
struct RequestHead {
    std::vector<std::string> host, origin, content_length, transfer_encoding;
};

/// By what names a server is called.
struct ServerNames {
    std::string address;            ///< at which it listens
    std::string machine;            ///< its name in the network; empty: none
    std::vector<std::string> hosts; ///< further names, and those of pages that may ask
};

/// Names are compared without ports, since a port may be forwarded.
///
/// Host. A page that has its own name point to this machine (DNS rebinding) sends its own name.
/// So the host must be a loopback name, the address, the machine or one of `hosts`; where the
/// server is reached from outside, also any address in digits, which cannot point elsewhere. A
/// request without one is of no browser. Origin. Browsers alone send it, with the page that
/// asks: one of a loopback name, the address or one of `hosts`. Length. One Content-Length in
/// digits, or chunks.
/// @return the answer, 403 or 400, to a request that is refused
[[nodiscard]] std::optional<HttpReply> refused_by_head(const RequestHead& head,
                                                       const ServerNames& names);

/// "localhost", "127.0.0.1", "::1"
[[nodiscard]] bool is_loopback(const std::string& name);

} // namespace app
