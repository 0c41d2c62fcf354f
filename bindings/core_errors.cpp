// The library's exceptions for Python, with the place of the fault as attributes.
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>

#include "bindings/core.hpp"
#include "bindings/vector_caster.hpp"
#include "reference/error.hpp"

namespace nb = nanobind;

namespace minkref::python {
namespace {

PyObject* bad_input = nullptr;
PyObject* limit_exceeded = nullptr;
PyObject* undecided_sign = nullptr;

PyObject* new_type(nb::module_& module, const char* name, const char* doc, PyObject* base) {
  const std::string qualified = "minkref._core." + std::string(name);
  PyObject* type = PyErr_NewExceptionWithDoc(qualified.c_str(), doc, base, nullptr);
  if (type == nullptr) throw nb::python_error();
  module.attr(name) = nb::handle(type);
  return type;
}

void raise(PyObject* type, const BadInput& error) {
  const Place& place = error.place();
  nb::object value = nb::handle(type)(error.what());
  value.attr("code") = error.code();
  value.attr("problem") = error.problem();
  value.attr("mend") = error.mend();
  value.attr("source") = place.source;
  value.attr("line") = place.line;
  value.attr("ring") = place.ring;
  value.attr("face") = place.face;
  value.attr("vertices") = place.vertices;
  value.attr("coordinates") = place.coordinates;
  value.attr("other_face") = place.other_face;
  value.attr("other_ring") = place.other_ring;
  value.attr("other_vertices") = place.other_vertices;
  PyErr_SetObject(type, value.ptr());
}

void translate(const std::exception_ptr& pointer, void*) {
  try {
    std::rethrow_exception(pointer);
  } catch (const LimitExceeded& error) {
    raise(limit_exceeded, error);
  } catch (const BadInput& error) {
    raise(bad_input, error);
  } catch (const UndecidedSign& error) {
    PyErr_SetString(undecided_sign, error.what());
  }
}

}  // namespace

void bind_errors(nb::module_& module) {
  bad_input =
      new_type(module, "BadInput",
               "An input that is refused. Attributes: code, problem, mend, source, line, ring, "
               "face, vertices, coordinates, other_face, other_ring, other_vertices.",
               PyExc_ValueError);
  limit_exceeded = new_type(module, "LimitExceeded", "A stated limit was reached.", bad_input);
  undecided_sign =
      new_type(module, "UndecidedSign", "A certifying arithmetic could not prove a sign.",
               PyExc_ArithmeticError);
  nb::register_exception_translator(translate);
}

}  // namespace minkref::python
