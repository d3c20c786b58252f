// SPDX-License-Identifier: GPL-3.0-or-later
// Part of every program that is built under sanitizers: options of the runtime, before ASAN_OPTIONS is read.

// The runtimes up to g++ 13 take some blocks of thread-local storage for ones with a header that glibc stopped writing
// at 2.25, read address and length out of what lies before them, and the search for leaks dies there at the program's
// end, now and then ("Tracer caught signal 11"). Not followed at all, such blocks cannot lead it astray.
extern "C" const char* __asan_default_options();
extern "C" const char* __asan_default_options() { return "intercept_tls_get_addr=0"; }
