// Vectors as lists, instead of nanobind/stl/vector.h: interrupts can stop a list of millions.
#pragma once

#include <nanobind/stl/detail/nb_list.h>

#include <utility>
#include <vector>

NAMESPACE_BEGIN(NB_NAMESPACE)
NAMESPACE_BEGIN(detail)

template <typename Type, typename Alloc>
struct type_caster<std::vector<Type, Alloc>> : list_caster<std::vector<Type, Alloc>, Type> {
  using Element = make_caster<Type>;

  /// Stops when a signal's handler raises an exception, or an element has no Python form.
  template <typename T>
  static handle from_cpp(T&& source, rv_policy policy, cleanup_list* cleanup) noexcept {
    constexpr unsigned elements_between_looks = 4096;
    static unsigned elements = 0;  // of all lists; the lock of the interpreter guards it
    object list = steal(PyList_New(static_cast<Py_ssize_t>(source.size())));
    if (!list.is_valid()) return {};
    Py_ssize_t index = 0;
    for (auto&& value : source) {
      if (++elements % elements_between_looks == 0 && PyErr_CheckSignals() != 0) return {};
      const handle element = Element::from_cpp(forward_like_<T>(value), policy, cleanup);
      if (!element.is_valid()) return {};
      PyList_SET_ITEM(list.ptr(), index++, element.ptr());
    }
    return list.release();
  }
};

NAMESPACE_END(detail)
NAMESPACE_END(NB_NAMESPACE)
