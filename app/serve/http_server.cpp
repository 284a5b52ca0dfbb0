#include "app/serve/http_server.hpp"

#include "app/serve/http_connection.hpp"

#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <stdexcept>
#include <stop_token>
#include <thread>

namespace app {
namespace {

using Clock = std::chrono::steady_clock;

constexpr const char* kJson = "application/json";
constexpr int kWaiting = 128; ///< connections that the system takes in before they are served

/// Set where the rest of the connection of this thread cannot be read as requests.
thread_local bool hang_up = false;

void send(httplib::Response& response, const HttpReply& reply)
{
    response.status = reply.status;
    response.set_content(reply.body, kJson);
}

void send_and_hang_up(httplib::Response& response, const HttpReply& reply)
{
    send(response, reply);
    response.set_header("Connection", "close");
    hang_up = true;
}

/// The library's server over connections of ours.
class Server final : public httplib::Server {
  public:
    explicit Server(const HttpOptions& o)
        : limits_{o.most_head_bytes, o.most_seconds, o.silent_seconds}
    {
    }
    /// After it is bound. The library asks for a queue of five.
    void lengthen_queue() { ::listen(svr_sock_, kWaiting); }

  private:
    /// Version 0.18 of the library takes the addresses of both sides, which nothing here reads.
    template <class Library>
    static bool answer(Library& server, HttpConnection& connection, bool& closed)
    {
        if constexpr (requires { server.process_request(connection, false, closed, nullptr); })
            return server.process_request(connection, false, closed, nullptr);
        else
            return server.process_request(connection, "", 0, "", 0, false, closed, nullptr);
    }

    bool process_and_close_socket(socket_t socket) override
    {
        const std::function<bool()> ended = [this] { return svr_sock_ == INVALID_SOCKET; };
        HttpConnection connection(socket, limits_, ended);
        bool goes_on = true;
        while (goes_on && !ended() && connection.next_request()) {
            hang_up = false;
            bool closed = false;
            goes_on = answer(*this, connection, closed) && !closed && !hang_up &&
                      !connection.is_broken();
        }
        connection.say_goodbye();
        ::close(socket);
        return goes_on;
    }

    ConnectionLimits limits_;
};

/// The body of a request, within the limits; or why not.
struct Body {
    std::string text;
    int status = 200;
    std::string trouble;
};

Body read_body(const httplib::Request& request, const httplib::Response& response,
               const httplib::ContentReader& read, const HttpOptions& o)
{
    Body body;
    if (request.is_multipart_form_data()) return {{}, 400, "send the JSON itself, not a form"};
    const auto begin = Clock::now();
    const bool whole = read([&](const char* data, std::size_t n) {
        if (body.text.size() + n > o.most_bytes)
            body.status = 413;
        else if (std::chrono::duration<double>(Clock::now() - begin).count() > o.most_seconds)
            body.status = 408;
        else
            body.text.append(data, n);
        return body.status == 200;
    });
    if (!whole && response.status == 413) body.status = 413; // by its Content-Length
    if (body.status == 413)
        body.trouble = "the request is larger than " + std::to_string(o.most_bytes) + " bytes";
    else if (body.status == 408)
        body.trouble = "the request did not arrive in time";
    else if (!whole)
        body = {{}, 400, "the request is broken off or malformed"};
    return body;
}

std::vector<std::string> sent(const httplib::Request& request, const char* header)
{
    std::vector<std::string> values;
    const auto [first, last] = request.headers.equal_range(header);
    for (auto at = first; at != last; ++at) values.push_back(at->second);
    return values;
}

RequestHead head_of(const httplib::Request& request)
{
    return {sent(request, "Host"), sent(request, "Origin"), sent(request, "Content-Length"),
            sent(request, "Transfer-Encoding")};
}

/// Reply to what the library refuses by itself: unknown paths and methods, headers that are
/// none.
HttpReply refused(int status)
{
    if (status == 404) return umbridge_error(404, "InvalidInput", "no such path or method");
    if (status == 413) return umbridge_error(413, "InvalidInput", "the request is too large");
    return umbridge_error(status, "InvalidInput",
                          "the request is malformed, or its head is too long");
}

/// The library would let another program listen at the same port.
void only_one(socket_t socket)
{
    const int yes = 1;
    ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
}

void set_limits(httplib::Server& server, const HttpOptions& o)
{
    server.set_payload_max_length(o.most_bytes);
    server.set_read_timeout(o.silent_seconds);
    server.set_write_timeout(o.silent_seconds);
    server.set_keep_alive_timeout(o.silent_seconds);
    server.set_keep_alive_max_count(1'000'000);
    server.set_tcp_nodelay(true);
    server.set_socket_options(only_one);
    server.new_task_queue = [n = static_cast<std::size_t>(o.connections)] {
        return new httplib::ThreadPool(n); // the library takes it
    };
}

void set_answers(httplib::Server& server, const HttpOptions& o,
                 std::span<const ServedModel> models)
{
    server.set_pre_routing_handler(
        [names = o.names](const httplib::Request& request, httplib::Response& response) {
            const std::optional<HttpReply> refusal = refused_by_head(head_of(request), names);
            if (!refusal) return httplib::Server::HandlerResponse::Unhandled;
            send_and_hang_up(response, *refusal); // its body is not read
            return httplib::Server::HandlerResponse::Handled;
        });
    server.Get("/Info", [models](const httplib::Request&, httplib::Response& response) {
        send(response, umbridge_info(models));
    });
    for (const char* const path : kUmbridgePaths)
        server.Post(path, [=](const httplib::Request& request, httplib::Response& response,
                              const httplib::ContentReader& read) {
            const Body body = read_body(request, response, read, o);
            if (body.status == 200)
                send(response, umbridge_reply(models, path, body.text));
            else
                send_and_hang_up(response,
                                 umbridge_error(body.status, "InvalidInput", body.trouble));
        });
    server.set_error_handler([](const httplib::Request&, httplib::Response& response) {
        if (response.body.empty()) send(response, refused(response.status));
    });
    server.set_exception_handler(
        [](const httplib::Request&, httplib::Response& response, std::exception_ptr) {
            send(response, umbridge_error(500, "InvalidOutput", "the server is shutting down"));
        });
}

} // namespace

void serve_http(const HttpOptions& options, std::span<const ServedModel> models,
                const std::function<void(int port)>& listening,
                const std::function<bool()>& ended)
{
    Server server(options);
    set_limits(server, options);
    set_answers(server, options, models);
    const std::string& address = options.names.address;
    const int port = options.port == 0 ? server.bind_to_any_port(address)
                     : server.bind_to_port(address, options.port) ? options.port
                                                                  : -1;
    if (port < 0)
        throw std::runtime_error("cannot listen at " + address + ":" +
                                 std::to_string(options.port) + ": " + std::strerror(errno));
    server.lengthen_queue();
    const std::jthread watch([&](const std::stop_token& done) {
        while (!done.stop_requested() &&
               !(ended() && server.is_running())) // else stop() is lost
            std::this_thread::sleep_for(std::chrono::milliseconds(100));
        server.stop();
    });
    listening(port);
    server.listen_after_bind();
}

} // namespace app
