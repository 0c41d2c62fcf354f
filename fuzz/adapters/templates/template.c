/* A sum in C for `minkref verify so:./NAME_adapter.so:minkowski_sum`: here of convex polygons. Put
 * your own call into `minkowski_sum`, and say in `minkref_hello` what it can do (the words are in
 * docs/adapter-protocol.md). `minkref adapter header` prints where minkref_adapter.h is. */
#include <stdlib.h>

const char* minkref_hello(void) {
  return "{\"name\": \"NAME\", \"version\": \"1\", \"language\": \"C\", \"arithmetic\": \"float64\","
         " \"tolerance\": {\"absolute\": \"0\", \"relative\": \"1e-9\"},"
         " \"capabilities\": [\"plane\"]}";
}

/* The number of the leftmost vertex of a ring, of these the lowest. */
static int leftmost(const double* xy, int count) {
  int best = 0;
  for (int k = 1; k < count; ++k) {
    if (xy[2 * k] < xy[2 * best] ||
        (xy[2 * k] == xy[2 * best] && xy[2 * k + 1] < xy[2 * best + 1])) {
      best = k;
    }
  }
  return best;
}

/* PUT YOUR OWN CALL HERE. For an offset declare "sum": "none" and "offset", and write instead
 *   int offset(const minkref_set* P, double radius, minkref_set* grown)
 * A set is a list of rings: ring r has sizes[r] vertices, which follow one
 * another in xy. is_hole[r] is 1 for a hole, of the last outer ring before it. To take sets of
 * several rings, declare "non-convex", "holes" and "components". */
int minkowski_sum(const minkref_set* sP, const minkref_set* Q, minkref_set* sum) {
  if (sP->rings != 1 || Q->rings != 1) return MINKREF_SKIPPED;
  const int n = sP->sizes[0], m = Q->sizes[0];
  const int p = leftmost(sP->xy, n), q = leftmost(Q->xy, m);
  sum->sizes = malloc(sizeof(int));
  sum->xy = malloc(2 * (size_t)(n + m) * sizeof(double));
  if (sum->sizes == NULL || sum->xy == NULL) return MINKREF_ERRORED;
  /* The edges of both in the order of their directions. */
  int count = 0;
  for (int i = 0, j = 0; i < n || j < m; ++count) {
    const double* a = sP->xy + 2 * ((p + i) % n);
    const double* b = sP->xy + 2 * ((p + i + 1) % n);
    const double* c = Q->xy + 2 * ((q + j) % m);
    const double* d = Q->xy + 2 * ((q + j + 1) % m);
    sum->xy[2 * count] = a[0] + c[0];
    sum->xy[2 * count + 1] = a[1] + c[1];
    double turn = (b[0] - a[0]) * (d[1] - c[1]) - (b[1] - a[1]) * (d[0] - c[0]);
    if (j == m) turn = 1;
    if (i == n) turn = -1;
    i += turn >= 0;
    j += turn <= 0;
  }
  sum->rings = 1; /* is_hole stays NULL: a ring is what it winds around */
  sum->sizes[0] = count;
  return MINKREF_RESULT;
}
