# Known answers judged natively (README.md): a build folder for `mutants --build`, in which probes are linked
# with a little OpenCL of our own. Judge and earlier labs are those of the build folder above.

NATIVE := $(OUT)/native
# The package clang, or what PoCL's own package brings along.
NATIVE_CLANG := $(firstword $(wildcard /usr/bin/clang /usr/bin/clang-[0-9] /usr/bin/clang-[0-9][0-9]))
NATIVE_OPENCL := $(NATIVE)/libOpenCL.so
NATIVE_SOURCES := $(filter-out tests/native/sanitized.c,$(wildcard tests/native/*.c)) $(addprefix common/,path.c text_file.c message.c complain.c clean_text.c utf8.c)

# A path from the root, for what is run in another folder; the course's own may hold blanks.
from_root = $(if $(filter /%,$(1)),$(1),$(CURDIR)/$(1))

# A library's code may lie anywhere.
$(NATIVE)/obj/%.c.o: %.c $(FLAG_FILES)
	$(call compile,$(CC) $(CFLAGS) -fPIC -DCLANG='"$(NATIVE_CLANG)"' -DNATIVE_CACHE='"$(call from_root,$(NATIVE)/kernels)"' \
	    -DNATIVE_HEADER='"$(call from_root,tests/native/kernels.h)"', for kernels)
$(NATIVE)/obj/builtins.o: tests/native/builtins.cl tests/native/kernels.h $(FLAG_FILES)
	@mkdir -p $(@D)
	$(call say,compile $<)$(NATIVE_CLANG) -x cl -cl-std=CL1.2 -Xclang -finclude-default-header -Xclang -fdeclare-opencl-builtins \
	    $(WARNINGS) -O2 -fPIC -ffp-contract=off -c $< -o $@
$(NATIVE_OPENCL): $(NATIVE_SOURCES:%=$(NATIVE)/obj/%.o) $(NATIVE)/obj/builtins.o
	@mkdir -p $(@D)/kernels
	$(call say,link    $@)$(CC) -shared $^ -ldl -lpthread -lm -o $@

# What the grader links a probe with (tests/grader/run/variant_start.c): libcommon.a is a text here that names
# two libraries to the linker.
$(NATIVE)/libcommon.a: $(OUT)/libcommon.a $(NATIVE_OPENCL)
	@printf 'INPUT("%s" "%s")\n' '$(call from_root,$<)' '$(call from_root,$(word 2,$^))' >$@
$(NATIVE)/tools $(NATIVE)/judges $(NATIVE)/earlier $(NATIVE)/no_macros.h:
	@mkdir -p $(NATIVE) && ln -sfn ../$(@F) $@
$(NATIVE)/probes/%.o: $(OUT)/probes/%.o
	@mkdir -p $(@D) && cp $< $@
$(filter-out %.o,$(PROBES:$(OUT)/%=$(NATIVE)/%)): $(NATIVE)/probes/%: $(OUT)/probes/%.o $(NATIVE_OPENCL)
	$(call link,'$(call from_root,$(NATIVE_OPENCL))' -lm)
# In a handout: is there a device? Here always.
$(NATIVE)/probes/find_device: $(call objects,tests/probes/find_device.c) $(OUT)/libcommon.a $(NATIVE_OPENCL)
	$(call link,'$(call from_root,$(NATIVE_OPENCL))' -lm)
.PHONY: native lab-native
# What make watch judges one lab with.
lab-native: $(NATIVE)/libcommon.a $(addprefix $(NATIVE)/,tools judges earlier no_macros.h probes/find_device) \
    $(filter $(addprefix $(NATIVE)/probes/,$(graded_lab) $(graded_lab).o),$(PROBES:$(OUT)/%=$(NATIVE)/%))
native: grader $(PROBES:$(OUT)/%=$(NATIVE)/%) $(NATIVE)/libcommon.a $(NATIVE)/tools $(NATIVE)/judges $(NATIVE)/earlier $(NATIVE)/no_macros.h
