// SPDX-License-Identifier: GPL-3.0-or-later
//
// C++ exceptions on WebAssembly's own, for a C++ runtime library that was built without them: what
// -fwasm-exceptions makes the compiler call, after the Itanium C++ ABI. One thread. A thrown value
// travels as the address of its Header, as the one operand of the tag __cpp_exception.
#include <cxxabi.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <typeinfo>

namespace {

struct alignas(16) Header {
  const std::type_info* type;
  void* (*destroy)(void*);  // of this machine's convention: returns its argument
  std::size_t references;  // handlers, exception_ptrs and the throw itself
  std::size_t handlers;    // that are at work
  void* caught;            // the value as the type of the handler that was found
  Header* outer;           // the exception whose handler was at work before

  void* value() { return this + 1; }
  static Header* of(void* value) { return static_cast<Header*>(value) - 1; }
};

Header* innermost = nullptr;  // of those whose handlers are at work
unsigned in_flight = 0;

[[noreturn]] void raise(Header* header) {
  ++in_flight;
  __builtin_wasm_throw(0, header);
}

void release(Header* header) {
  if (--header->references != 0) return;
  if (header->destroy != nullptr) header->destroy(header->value());
  std::free(header);
}

// The type_info objects of classes, as the ABI lays them out (2.9.5): a virtual table, the name,
// and then the bases.
struct SingleBaseLayout {
  const void* virtual_table;
  const char* name;
  const std::type_info* base;
};
struct Base {
  const std::type_info* type;
  long flags;  // the offset in the upper bits
};
struct ManyBasesLayout {
  const void* virtual_table;
  const char* name;
  unsigned flags;
  unsigned count;
  Base bases[1];
};
constexpr long kIsVirtual = 1;
constexpr long kIsPublic = 2;
constexpr int kOffsetShift = 8;

const void* virtual_table(const std::type_info& type) {
  return *reinterpret_cast<const void* const*>(&type);
}

// `value` of type `thrown` as a `wanted`, its own type or a public base; null where it is none.
void* as(void* value, const std::type_info& thrown, const std::type_info& wanted) {
  if (thrown == wanted) return value;
  // Its virtual table says of what kind a class is; these are samples of the two kinds with bases.
  struct Root {};
  struct Other {};
  struct Single : Root {};
  struct Many : Root, Other {};
  if (virtual_table(thrown) == virtual_table(typeid(Single))) {
    return as(value, *reinterpret_cast<const SingleBaseLayout&>(thrown).base, wanted);
  }
  if (virtual_table(thrown) != virtual_table(typeid(Many))) return nullptr;
  const auto& layout = reinterpret_cast<const ManyBasesLayout&>(thrown);
  for (unsigned i = 0; i < layout.count; ++i) {
    const Base& base = layout.bases[i];
    if ((base.flags & kIsPublic) == 0) continue;
    std::ptrdiff_t offset = base.flags >> kOffsetShift;
    if ((base.flags & kIsVirtual) != 0) {
      const char* table = *static_cast<const char* const*>(value);
      offset = *reinterpret_cast<const std::ptrdiff_t*>(table + offset);
    }
    if (void* found = as(static_cast<char*>(value) + offset, *base.type, wanted)) return found;
  }
  return nullptr;
}

// The table of a function's handlers (the "language-specific data area"), read from its front.
class TableReader {
 public:
  explicit TableReader(const std::uint8_t* at) : at_(at) {}
  const std::uint8_t* at() const { return at_; }
  std::uint8_t byte() { return *at_++; }
  std::size_t count() { return static_cast<std::size_t>(bits(false)); }
  std::ptrdiff_t step() { return static_cast<std::ptrdiff_t>(bits(true)); }

 private:
  // LEB128.
  std::uint64_t bits(bool is_signed) {
    std::uint64_t value = 0;
    unsigned shift = 0;
    std::uint8_t next = 0;
    do {
      next = byte();
      value |= static_cast<std::uint64_t>(next & 0x7FU) << shift;
      shift += 7;
    } while ((next & 0x80U) != 0);
    if (is_signed && (next & 0x40U) != 0 && shift < 64) value |= ~std::uint64_t{0} << shift;
    return value;
  }

  const std::uint8_t* at_;
};

constexpr std::uint8_t kOmitted = 0xFF;

// The number of the handler of landing pad `index` that takes the exception: what the compiler's code
// compares with the numbers of its types; 0: none does, and only clean-up is wanted.
std::size_t handler_for(Header* header, std::size_t index, const std::uint8_t* table) {
  TableReader reader(table);
  if (reader.byte() != kOmitted) std::terminate();  // a base of landing pads: none on WebAssembly
  const std::type_info* const* types = nullptr;     // counted down from here, from 1
  if (reader.byte() != kOmitted) {
    const std::size_t offset = reader.count();
    types = reinterpret_cast<const std::type_info* const*>(reader.at() + offset);
  }
  reader.byte();  // how call sites are encoded: always LEB128
  const std::size_t length = reader.count();
  const std::uint8_t* const actions = reader.at() + length;
  for (std::size_t i = 0; i < index; ++i) {
    reader.count();
    reader.count();
  }
  reader.count();  // the landing pad: the compiler's code is in it already
  std::size_t action = reader.count();
  if (action == 0) return 0;
  TableReader chain(actions + action - 1);
  for (;;) {
    const std::ptrdiff_t number = chain.step();
    const std::uint8_t* const next = chain.at();
    const std::ptrdiff_t step = chain.step();
    if (number > 0) {
      const std::type_info* wanted = types[-number];
      header->caught = header->value();
      if (wanted == nullptr) return static_cast<std::size_t>(number);
      if (void* found = as(header->value(), *header->type, *wanted)) {
        header->caught = found;
        return static_cast<std::size_t>(number);
      }
    }
    if (number < 0) std::terminate();  // a list of allowed exceptions: C++20 has none
    if (step == 0) return 0;
    chain = TableReader(next + step);
  }
}

}  // namespace

extern "C" {

// What the compiler's code writes before it asks for the handler, and reads after.
struct LandingPad {
  std::size_t index;
  const std::uint8_t* table;
  std::size_t selector;
};
LandingPad __wasm_lpad_context;

int _Unwind_CallPersonality(void* exception) {
  __wasm_lpad_context.selector = handler_for(static_cast<Header*>(exception),
                                             __wasm_lpad_context.index, __wasm_lpad_context.table);
  return 0;
}

void* __cxa_allocate_exception(std::size_t size) noexcept {
  void* memory = std::malloc(sizeof(Header) + size);
  if (memory == nullptr) std::terminate();
  return static_cast<Header*>(memory)->value();
}
void __cxa_free_exception(void* value) noexcept { std::free(Header::of(value)); }

void __cxa_throw(void* value, std::type_info* type, void* (*destroy)(void*)) {
  Header* header = Header::of(value);
  *header = Header{type, destroy, 1, 0, value, nullptr};
  raise(header);
}

void* __cxa_get_exception_ptr(void* exception) noexcept {
  return static_cast<Header*>(exception)->caught;
}

void* __cxa_begin_catch(void* exception) noexcept {
  auto* header = static_cast<Header*>(exception);
  --in_flight;
  if (header->handlers++ == 0) {
    header->outer = innermost;
    innermost = header;
  }
  return header->caught;
}

// The throw's own reference ends with the last handler, unless that throws it again.
void __cxa_end_catch() {
  Header* header = innermost;
  if (header == nullptr || --header->handlers != 0) return;
  innermost = header->outer;
  release(header);
}

void __cxa_rethrow() {
  if (innermost == nullptr) std::terminate();
  ++innermost->references;
  raise(innermost);
}

unsigned __cxa_uncaught_exceptions() noexcept { return in_flight; }
bool __cxa_uncaught_exception() noexcept { return in_flight != 0; }

// std::exception_ptr.
void* __cxa_current_primary_exception() noexcept {
  if (innermost == nullptr) return nullptr;
  ++innermost->references;
  return innermost->value();
}
void __cxa_increment_exception_refcount(void* value) noexcept {
  if (value != nullptr) ++Header::of(value)->references;
}
void __cxa_decrement_exception_refcount(void* value) noexcept {
  if (value != nullptr) release(Header::of(value));
}
void __cxa_rethrow_primary_exception(void* value) {
  if (value == nullptr) return;
  Header* header = Header::of(value);
  ++header->references;
  raise(header);
}

// What is local to the one thread lives as long as the module.
int __cxa_thread_atexit(void* (*)(void*), void*, void*) noexcept { return 0; }

}  // extern "C"
