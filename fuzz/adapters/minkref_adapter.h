/* A Minkowski sum of your own in C, for `minkref verify so:./libmine.so:my_sum`.
 *
 *   #include "minkref_adapter.h"
 *   int my_sum(const minkref_set* sP, const minkref_set* Q, minkref_set* sum) { ... }
 *
 *   cc -shared -fPIC -O2 mine.c -o libmine.so
 *
 * In C++ the function has to be extern "C", as the declarations below are. No library is needed. */
#ifndef MINKREF_ADAPTER_H
#define MINKREF_ADAPTER_H

#ifdef __cplusplus
extern "C" {
#endif

/* A set in the plane: its rings one after the other, the vertices of ring r being the next sizes[r]
 * pairs in xy. Outer rings run counter-clockwise, holes clockwise; the holes of a polygon follow
 * its outer ring; the last vertex is not the first again. No rings are the empty set. */
typedef struct minkref_set {
  int rings;              /* how many */
  int* sizes;             /* of each ring, its vertices */
  unsigned char* is_hole; /* of each ring, 1 for a hole and 0 for an outer ring */
  double* xy;             /* x, y of each vertex: 2 * (sum of sizes) numbers */
} minkref_set;

/* Return values of the function. */
enum {
  MINKREF_RESULT = 0,   /* *sum is the sum */
  MINKREF_SKIPPED = 1,  /* it does not take this case */
  MINKREF_REJECTED = 2, /* it says that the input is invalid */
  MINKREF_ERRORED = 3   /* it failed; any other number means the same */
};

/* The sum of sP, which is scaled already, and Q. Both belong to the caller, who may free them after
 * the call; they are not to be changed. *sum is all zero at the call. For MINKREF_RESULT the
 * function sets `rings`, and `sizes` and `xy` to what malloc gave; the caller frees them with free.
 * Rings may run either way and come in any order. Where `is_hole` is set (by malloc too), a ring is
 * a hole of the outer ring before it; where it stays NULL, the points with a winding number greater
 * than zero are meant. Whatever the function does to its process, each target runs in one of its
 * own. */
typedef int minkref_sum_function(const minkref_set* sP, const minkref_set* Q, minkref_set* sum);

/* The same for a library that declares "sum": "none" and "offset" or "union": P grown by a disc of
 * this radius (below 0, if it declares "inset": eroded), and the union of `count` sets. */
typedef int minkref_offset_function(const minkref_set* P, double radius, minkref_set* grown);
typedef int minkref_union_function(const minkref_set* sets, int count, minkref_set* united);

/* How corners and ends grow. */
enum {
  MINKREF_ROUND = 0,
  MINKREF_MITRE = 1, /* a join, with a limit */
  MINKREF_BEVEL = 2, /* a join */
  MINKREF_SQUARE = 3,
  MINKREF_SHARP = 4, /* a join: a mitre without limit */
  MINKREF_FLAT = 5   /* a cap */
};

typedef struct minkref_manner {
  int are_lines; /* 1: the rings of P are open lines, each from its first vertex to its last */
  int join;
  double limit; /* of a mitre: the most distance of its tip from the corner, in radii; else 0 */
  int cap;      /* of lines; else MINKREF_ROUND */
} minkref_manner;

/* Replaces minkref_offset_function if the library declares "line-offset", a join or a cap, and is
 * then called for round joins, too. */
typedef int minkref_joined_offset_function(const minkref_set* P, double radius,
                                           const minkref_manner* manner, minkref_set* grown);

/* Optional: the declaration, the members of the answer to `hello` as JSON
 * (docs/adapter-protocol.md). The library owns the text. Numbers are doubles, so "numbers" is
 * "double" whatever the text says. Defaults:
 *   {"arithmetic": "float64", "tolerance": {"absolute": "0", "relative": "1e-9"}, "sum": "region",
 *    "capabilities": ["plane", "non-convex", "holes", "components"]} */
const char* minkref_hello(void);

#ifdef __cplusplus
}
#endif

#endif
