/* What a program provides to every library: an allocator that counts, and a progress callback.
 * Prints the version and the statuses that a function may return. */
#include <orbicube/base.h>
#include <stdio.h>

static int32_t show_progress(const char* phase, uint64_t done, uint64_t total, double best, void* user) {
  (void)best;
  (void)user;
  printf("%s: %llu of %llu\n", phase, (unsigned long long)done, (unsigned long long)total);
  return 0; /* go on */
}

int main(void) {
  obc_host host;
  obc_status status;

  if (obc_host_init(&host, sizeof host) != OBC_OK) return 1;
  host.thread_count = 2;
  host.progress = show_progress; /* lend the host to any computation: obc_..._compute(..., &host, &error) */

  printf("orbicube base %u\n", (unsigned)obc_base_version());
  for (status = OBC_OK; status >= OBC_INTERNAL; --status)
    printf("%d: %s\n", (int)status, obc_status_name(status));
  return host.progress("done", 1, 1, 0.0, host.progress_user) == 0 ? 0 : 1;
}
