# How memcheck is built, in the course and in handouts: the program, and for each sanitizer an OpenCL of our
# own (tests/native) with which it links a probe, in the sandbox.

MEMCHECK_SOURCES := $(wildcard tests/memcheck/*.c)
$(OUT)/tools/memcheck: $(call objects,$(MEMCHECK_SOURCES)) $(OUT)/libgrader.a $(OUT)/libcommon.a | $(OUT)/libimage_codec.so
	$(call link,$(LIBRARIES))
grader: $(OUT)/tools/memcheck

MEMCHECK := $(OUT)/memcheck
MEMCHECK_LIBRARIES := $(MEMCHECK)/address.so $(MEMCHECK)/memory.so
MEMCHECK_NATIVE := $(filter-out tests/native/plain.c,$(wildcard tests/native/*.c)) \
    $(addprefix common/,path.c text_file.c message.c complain.c clean_text.c utf8.c)
# The host's side has no sanitizer: it says itself which bytes of a memory object were set.
$(MEMCHECK)/obj/%.c.o: %.c $(FLAG_FILES) $(MEMCHECK)/ready
	$(call compile,clang $(filter-out -fsanitize%,$(CFLAGS)) -fPIC -DNATIVE_CACHE='"out"' -DNATIVE_HEADER='"lib/kernels.h"' \
	    -DNATIVE_FAULT='"out/fault"', for memcheck)
$(MEMCHECK)/address.o: SANITIZER = address
$(MEMCHECK)/memory.o: SANITIZER = memory -fsanitize-memory-track-origins -mllvm -msan-eager-checks=0
$(MEMCHECK)/address.o $(MEMCHECK)/memory.o: tests/native/builtins.cl tests/native/kernels.h $(FLAG_FILES) $(MEMCHECK)/ready
	$(call say,compile $< for memcheck)clang -x cl -cl-std=CL1.2 -Xclang -finclude-default-header \
	    -Xclang -fdeclare-opencl-builtins $(WARNINGS) -O0 -g -fno-omit-frame-pointer -fPIC -ffp-contract=off -fsanitize=$(SANITIZER) -c $< -o $@
$(MEMCHECK_LIBRARIES): %.so: %.o $(MEMCHECK_NATIVE:%=$(MEMCHECK)/obj/%.o)
	$(call say,link    $@)clang -shared $^ -ldl -lpthread -lm -o $@
$(MEMCHECK)/ready:
	@mkdir -p $(@D) && printf 'int main(void) { return 0; }\n' >$@.c && \
	    for sanitizer in address memory; do clang -fsanitize=$$sanitizer $@.c -o $@.out || { \
	        echo "make memcheck: needs clang and its sanitizers: make setup, or install the packages clang and libclang-rt-dev" >&2; exit 2; }; done \
	    && touch $@

.PHONY: memcheck memcheck-libraries
memcheck-libraries: $(MEMCHECK_LIBRARIES)
memcheck: graded $(OUT)/tools/memcheck memcheck-libraries  ## look for indices out of range and unset values: LAB=03 [SUBMISSION=folder]
	@$(say_which_lab)
	@$(OUT)/tools/memcheck --build $(OUT) --lab "$$LAB" \
	    $(if $(SUBMISSION),--submission "$$SUBMISSION") $(if $(SEED),--seed "$$SEED") \
	    $(if $(TIME_LIMIT),--time-limit "$$TIME_LIMIT") $(verdict_is_no_fault)
