#pragma once
#include <exception>
#include <string>

namespace sturm::viewer {

/// Throws an Error of JavaScript with this message; nothing between here and the page is unwound.
[[noreturn]] void throw_to_page(const std::string& message);

namespace detail {

template <auto function>
struct Telling;

/// Exceptions are caught before they are told, so that everything below has been unwound.
template <class Result, class Call>
Result told(const Call& call) {
  static std::string message;
  try {
    return call();
  } catch (const std::exception& error) {
    message = error.what();
  }
  throw_to_page(message);
}

template <class Result, class Object, class... Arguments, Result (Object::*function)(Arguments...)>
struct Telling<function> {
  static Result call(Object& object, Arguments... arguments) {
    return told<Result>([&] { return (object.*function)(arguments...); });
  }
};

template <class Result, class Object, class... Arguments, Result (Object::*function)(Arguments...) const>
struct Telling<function> {
  static Result call(const Object& object, Arguments... arguments) {
    return told<Result>([&] { return (object.*function)(arguments...); });
  }
};

template <class Result, class... Arguments, Result (*function)(Arguments...)>
struct Telling<function> {
  static Result call(Arguments... arguments) {
    return told<Result>([&] { return function(arguments...); });
  }
};

}  // namespace detail

/// The same function for the page: what it throws becomes an Error with that message.
template <auto function>
constexpr auto telling() {
  return &detail::Telling<function>::call;
}

}  // namespace sturm::viewer
