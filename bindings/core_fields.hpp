// A struct's members as a dictionary's fields, each under its own name.
#pragma once

#include <boost/preprocessor/seq/for_each.hpp>
#include <boost/preprocessor/stringize.hpp>
#include <boost/preprocessor/variadic/to_seq.hpp>

#define MINKREF_PUT_MEMBER(r, from, member) fields[BOOST_PP_STRINGIZE(member)] = (from).member;

/// MINKREF_PUT(counts, faces, nodes) puts counts.faces and counts.nodes into `fields`.
#define MINKREF_PUT(from, ...) \
  BOOST_PP_SEQ_FOR_EACH(MINKREF_PUT_MEMBER, from, BOOST_PP_VARIADIC_TO_SEQ(__VA_ARGS__))
