/* Hostile C functions, for `so:./functions.so:NAME`. */
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "minkref_adapter.h"

const char* minkref_hello(void) {
  return "{\"arithmetic\": \"float64\", \"tolerance\": {\"relative\": \"1e-9\"}, "
         "\"capabilities\": [\"plane\"]}";
}

static int ring(minkref_set* sum, int rings, int size, double x) {
  sum->rings = rings;
  sum->sizes = malloc(sizeof(int));
  sum->sizes[0] = size;
  sum->is_hole = NULL;
  sum->xy = malloc(6 * sizeof(double));
  for (int k = 0; k < 6; ++k) sum->xy[k] = k == 2 || k == 5 ? 1 : 0;
  sum->xy[0] = x;
  return MINKREF_RESULT;
}

int rings_below_zero(const minkref_set* p, const minkref_set* q, minkref_set* sum) {
  (void)p, (void)q;
  return ring(sum, -1, 3, 0);
}

int rings_beyond_memory(const minkref_set* p, const minkref_set* q, minkref_set* sum) {
  (void)p, (void)q;
  return ring(sum, INT_MAX, 3, 0);
}

int size_below_zero(const minkref_set* p, const minkref_set* q, minkref_set* sum) {
  (void)p, (void)q;
  return ring(sum, 1, INT_MIN, 0);
}

int size_beyond_memory(const minkref_set* p, const minkref_set* q, minkref_set* sum) {
  (void)p, (void)q;
  return ring(sum, 1, INT_MAX, 0);
}

int no_arrays(const minkref_set* p, const minkref_set* q, minkref_set* sum) {
  (void)p, (void)q;
  sum->rings = 1;
  return MINKREF_RESULT;
}

int not_finite(const minkref_set* p, const minkref_set* q, minkref_set* sum) {
  (void)p, (void)q;
  return ring(sum, 1, 3, NAN);
}

int not_from_malloc(const minkref_set* p, const minkref_set* q, minkref_set* sum) {
  (void)p;
  *sum = *q;
  return MINKREF_RESULT;
}

int writes_into_its_operands(const minkref_set* p, const minkref_set* q, minkref_set* sum) {
  memset(p->xy - 4096, 0xff, 8192 * sizeof(double));
  (void)q;
  return ring(sum, 1, 3, 0);
}

int another_status(const minkref_set* p, const minkref_set* q, minkref_set* sum) {
  (void)p, (void)q, (void)sum;
  return INT_MIN;
}

int exits(const minkref_set* p, const minkref_set* q, minkref_set* sum) {
  (void)p, (void)q, (void)sum;
  exit(0);
}

int overflows_the_stack(const minkref_set* p, const minkref_set* q, minkref_set* sum) {
  volatile char large[1 << 16];
  large[0] = 1;
  return overflows_the_stack(p, q, sum) + large[0];
}
