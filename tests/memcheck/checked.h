// What stands before a student's files when they are compiled for memcheck: none may say that it is
// not to be checked. An attribute's name, also one that a macro joins, is an error at its line.
#pragma GCC poison no_sanitize __no_sanitize__
#pragma GCC poison no_sanitize_address __no_sanitize_address__
#pragma GCC poison no_sanitize_memory __no_sanitize_memory__
#pragma GCC poison no_sanitize_undefined __no_sanitize_undefined__
#pragma GCC poison no_address_safety_analysis __no_address_safety_analysis__
#pragma GCC poison disable_sanitizer_instrumentation __disable_sanitizer_instrumentation__
