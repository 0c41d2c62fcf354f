/// Small sets allocate all the time: stacks of allocations and a long quarantine would take most of
/// it. ASAN_OPTIONS=malloc_context_size=30 brings the stacks back for a finding.
extern "C" const char* __asan_default_options();
extern "C" const char* __asan_default_options() {
  return "malloc_context_size=0:quarantine_size_mb=4:thread_local_quarantine_size_kb=256";
}
