/// Exceptions of WebAssembly: functions that libc++abi has in other builds, and Debian's of
/// wasm32-wasi has not. The compiler calls them; tables of an object say which handler takes
/// which type ("Itanium C++ ABI: Exception Handling", level II, as LLVM lays it out for
/// WebAssembly). One thread.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <typeinfo>

namespace __cxxabiv1 {

/// As libc++abi declares it: the order of its virtual functions is what counts.
class __shim_type_info : public std::type_info {
  public:
    ~__shim_type_info() override;
    virtual void noop1() const;
    virtual void noop2() const;
    /// Moves `thrown` to the part of it that this type is.
    virtual bool can_catch(const __shim_type_info* type, void*& thrown) const = 0;
};

} // namespace __cxxabiv1

namespace {

using Type = __cxxabiv1::__shim_type_info;
using Bytes = const std::uint8_t*;
using Destructor = void* (*)(void*); // returns its object, as all do in WebAssembly

/// Lies before the object that is thrown.
struct alignas(16) Thrown {
    const Type* type;
    Destructor destroy;
    void* caught;  ///< the object as its handler sees it
    Thrown* below; ///< the exception whose handler threw this one
    int handlers;  ///< that are at it
    bool again;    ///< its handler threw it again
};

Thrown* handled = nullptr; // by the innermost handler

Thrown* head_of(void* object) { return static_cast<Thrown*>(object) - 1; }
void* object_of(Thrown* head) { return head + 1; }

constexpr int kTag = 0; // of C++ exceptions

[[noreturn]] void raise(Thrown* head)
{
    __builtin_wasm_throw(kTag, object_of(head));
    __builtin_unreachable();
}

std::uint64_t unsigned_number(Bytes& at)
{
    std::uint64_t value = 0;
    for (int shift = 0;; shift += 7) {
        const std::uint8_t byte = *at++;
        value |= std::uint64_t{byte & 0x7fU} << shift;
        if ((byte & 0x80U) == 0) return value;
    }
}

std::int64_t signed_number(Bytes& at)
{
    std::uint64_t value = 0;
    for (int shift = 0;;) {
        const std::uint8_t byte = *at++;
        value |= std::uint64_t{byte & 0x7fU} << shift;
        shift += 7;
        if ((byte & 0x80U) != 0) continue;
        if ((byte & 0x40U) != 0) value |= ~std::uint64_t{0} << shift;
        return static_cast<std::int64_t>(value);
    }
}

/// Number of the first type, in the list of this landing pad, that takes the exception; 0:
/// none.
int taker(Bytes table, std::size_t pad, Thrown& thrown)
{
    constexpr std::uint8_t kAbsent = 0xff;
    ++table; // landing pads are numbers here
    if (*table++ == kAbsent) return 0;
    const std::uint64_t to_types = unsigned_number(table);
    const Bytes types = table + to_types;
    ++table; // how call sites are written: as numbers
    const std::uint64_t length = unsigned_number(table);
    const Bytes actions = table + length;
    std::uint64_t action = 0;
    for (std::size_t i = 0; i <= pad; ++i) {
        static_cast<void>(unsigned_number(table));
        action = unsigned_number(table);
    }
    if (action == 0) return 0;
    for (Bytes at = actions + action - 1;;) {
        const std::int64_t number = signed_number(at);
        if (number > 0) {
            const Type* type = reinterpret_cast<const Type* const*>(types)[-number];
            void* object = object_of(&thrown);
            if (type == nullptr || type->can_catch(thrown.type, object)) {
                thrown.caught = object;
                return static_cast<int>(number);
            }
        }
        const Bytes from = at;
        const std::int64_t next = signed_number(at);
        if (next == 0) return 0;
        at = from + next;
    }
}

} // namespace

extern "C" {

/// Where the compiler says which landing pad was reached, and reads which handler goes on.
struct {
    std::size_t pad;
    Bytes table;
    std::size_t handler;
} __wasm_lpad_context;

int _Unwind_CallPersonality(void* object)
{
    Thrown& thrown = *head_of(object);
    thrown.caught = object;
    __wasm_lpad_context.handler = static_cast<std::size_t>(
        taker(__wasm_lpad_context.table, __wasm_lpad_context.pad, thrown));
    return 0;
}

/// Is named in tables, never called.
int __gxx_wasm_personality_v0() { std::abort(); }

void* __cxa_allocate_exception(std::size_t bytes)
{
    auto* head =
        static_cast<Thrown*>(std::aligned_alloc(16, (sizeof(Thrown) + bytes + 15) / 16 * 16));
    if (head == nullptr) std::terminate();
    *head = {};
    return object_of(head);
}

void __cxa_free_exception(void* object) { std::free(head_of(object)); }

[[noreturn]] void __cxa_throw(void* object, std::type_info* type, Destructor destroy)
{
    Thrown* head = head_of(object);
    head->type = static_cast<const Type*>(type);
    head->destroy = destroy;
    raise(head);
}

void* __cxa_get_exception_ptr(void* object) { return head_of(object)->caught; }

void* __cxa_begin_catch(void* object)
{
    Thrown* head = head_of(object);
    if (head->caught == nullptr) head->caught = object;
    head->again = false;
    if (head->handlers++ == 0) {
        head->below = handled;
        handled = head;
    }
    return head->caught;
}

void __cxa_end_catch()
{
    Thrown* head = handled;
    if (head == nullptr || --head->handlers > 0) return;
    handled = head->below;
    if (head->again) return;
    if (head->destroy != nullptr) head->destroy(object_of(head));
    std::free(head);
}

[[noreturn]] void __cxa_rethrow()
{
    if (handled == nullptr) std::terminate();
    handled->again = true;
    handled->caught = nullptr;
    raise(handled);
}

} // extern "C"
