# From circles to rays: build, draw, grade, test. `make help` lists the targets.
# Everything that is made goes under build/. A new folder in solutions/ needs no edit here.

BUILD ?= build
CC = gcc
CXX = g++
WARNINGS = -Wall -Wextra -Werror
INCLUDES = -Icommon -Ikernels
DEPENDENCIES = -MMD -MP
# `make SANITIZE=1` builds the same with the address and undefined sanitizers, in a folder of its own.
ifeq ($(SANITIZE),1)
OUT := $(BUILD)/sanitized
SANITIZERS = -fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer
else
OUT := $(BUILD)
endif
OPTIMISATION = -O2 -g
CFLAGS = -std=c11 -D_GNU_SOURCE $(OPTIMISATION) $(WARNINGS) $(SANITIZERS)
CXXFLAGS = -std=c++17 $(OPTIMISATION) $(WARNINGS) $(SANITIZERS)

.DELETE_ON_ERROR:
.SECONDARY:
.DEFAULT_GOAL := all

# `make V=1` shows whole commands.
say = $(if $(V),,@echo "  $(1)" && )

# Asked only when something is compiled, so that `make demo` can install pkg-config first.
IMAGE_CFLAGS = $(shell pkg-config --cflags OpenImageIO)
# Old tags, because the address sanitizer's dlopen() does not look at the new ones.
LIBRARIES = -Wl,--as-needed,--disable-new-dtags,-rpath,'$$ORIGIN/..' $(shell pkg-config --libs jansson) -lcsv -lseccomp -lOpenCL -lm

# In a handout (`make handout`) there are one lab, the solutions of those before it and no suites: what
# is for authors is left out below.
LABS := $(sort $(foreach tree,labs solutions,$(patsubst $(tree)/%/lab.json,%,$(wildcard $(tree)/*/lab.json))))
HANDOUT := $(if $(wildcard tests/suites),,yes)
# In examples: a lab that is there.
EXAMPLE_LAB := $(or $(if $(HANDOUT),$(firstword $(subst -, ,$(notdir $(wildcard labs/[0-9]*))))),03)

# The labs before one: what they deliver comes from their solutions.
earlier = $(strip $(eval reached :=)$(foreach l,$(LABS),$(if $(filter $(1),$(l)),$(eval \
    reached := 1))$(if $(reached),,$(l))))
# What is linked from those: every file of theirs but main.c.
earlier_sources = $(foreach l,$(call earlier,$(1)),\
    $(filter-out %/main.c,$(wildcard solutions/$(l)/*.c)))
# Where headers and kernels are looked for, after the lab's own folder.
include_path = -I kernels $(foreach l,$(call earlier,$(1)),-I solutions/$(l))

objects = $(patsubst %,$(OUT)/obj/%.o,$(1))
COMMON_OBJECTS := $(call objects,$(wildcard common/*.c))
PROGRAMS := $(patsubst %/lab.json,$(OUT)/%,$(wildcard $(foreach tree,labs solutions,$(LABS:%=$(tree)/%/lab.json))))

.PHONY: all
all: $(PROGRAMS) grader  ## build every lab, every solution and the grader

# ---- Compiling ------------------------------------------------------------------------------

# What is said here decides how everything is compiled.
THIS_FILE := $(firstword $(MAKEFILE_LIST))

$(OUT)/obj/%.c.o: %.c $(THIS_FILE)
	@mkdir -p $(@D)
	$(call say,compile $<)$(CC) $(CFLAGS) $(DEPENDENCIES) $(INCLUDES) $(EXTRA) -c $< -o $@

$(OUT)/obj/%.cpp.o: %.cpp $(THIS_FILE)
	@mkdir -p $(@D)
	$(call say,compile $<)$(CXX) $(CXXFLAGS) $(DEPENDENCIES) $(INCLUDES) $(IMAGE_CFLAGS) -fPIC -c $< -o $@

$(OUT)/libcommon.a: $(COMMON_OBJECTS)
	@rm -f $@
	@ar rcs $@ $^

# Loaded by whatever reads or writes a picture, from the folder above the program (image_codec.h).
CODEC := $(OUT)/libimage_codec.so
$(CODEC): $(call objects,common/image.cpp)
	$(call say,link    $@)$(CXX) $(SANITIZERS) -shared $^ $(shell pkg-config --libs OpenImageIO) -o $@

# One program a lab: $(1) is labs or solutions, $(2) the lab's name. What a student has half written may
# have warnings; the tests see to it that the skeletons have none.
define lab_program
$(OUT)/obj/$(1)/$(2)/%.o: EXTRA = $(if $(filter labs,$(1)),-Wno-error) -I $(1)/$(2) $(call include_path,$(2)) \
    -DLAB_NAME='"$(2)"' -DLAB_FOLDER='"$(1)/$(2)"' -DKERNEL_OPTIONS='"$(call include_path,$(2))"'
$(OUT)/$(1)/$(2): $(call objects,$(wildcard $(1)/$(2)/*.c)) $(OUT)/earlier/$(2).a $(OUT)/libcommon.a | $(CODEC)
	@mkdir -p $$(@D)
	$$(call say,link    $$@)$(CC) $(SANITIZERS) $$^ $$(LIBRARIES) -o $$@
endef
# The solutions of the labs before $(1) as an archive: the linker takes from it what the lab calls.
define earlier_archive
$(OUT)/earlier/$(1).a: $(call objects,$(call earlier_sources,$(1)))
	@mkdir -p $$(@D)
	@rm -f $$@
	@ar rcs $$@ $$^
endef
$(foreach tree,labs solutions,$(foreach l,$(LABS),\
    $(if $(wildcard $(tree)/$(l)/lab.json),$(eval $(call lab_program,$(tree),$(l))))))
$(foreach l,$(LABS),$(eval $(call earlier_archive,$(l))))

# Any other, as in a handout, which has one lab and the solutions before it.
$(OUT)/labs/% $(OUT)/solutions/%:
	@echo "make: found no lab for $@, expected $(filter $(@D)/%,$(PROGRAMS))" >&2; exit 2

# ---- The grader -----------------------------------------------------------------------------

GRADER_MAINS = $(addprefix tests/grader/,grade.c memcheck.c unpack_tool.c sandbox_init_tool.c)
GRADER_SOURCES := $(filter-out $(GRADER_MAINS),$(wildcard tests/grader/*.c))
# Judges of later labs get their trees and cameras from the solutions of labs 02, 04 and 06.
BUILDERS := $(wildcard solutions/02-kdtree-2d-build/kdtree2d_build.c \
    solutions/04-camera-rays/camera_from_view.c solutions/06-kdtree-3d-build/kdtree3d_build.c)
BUILDER_INCLUDES = $(addprefix -I ,$(sort $(dir $(BUILDERS))))
JUDGE_FOLDERS := tests/judge $(patsubst %/,%,$(wildcard tests/judge/*/))
GRADER_INCLUDES = -I tests/grader $(addprefix -I ,$(JUDGE_FOLDERS)) -I tests/mutation -I tests/probes -I tests/stand_ins -I tests/class $(BUILDER_INCLUDES)
$(OUT)/obj/tests/%.o: EXTRA = $(GRADER_INCLUDES)

# Process 1 of bubblewrap's sandboxes is a program inside the grader, never with the sanitizers.
SANDBOX_INIT := $(OUT)/obj/tests/grader/sandbox_init
$(SANDBOX_INIT): tests/grader/sandbox_init_tool.c $(THIS_FILE)
	@mkdir -p $(@D)
	$(call say,link    $@)$(CC) -std=c11 -D_GNU_SOURCE -O2 -s $(WARNINGS) $< -o $@
$(OUT)/obj/tests/grader/sandbox_init.c.o: EXTRA = $(GRADER_INCLUDES) -DSANDBOX_INIT='"$(SANDBOX_INIT)"'
$(OUT)/obj/tests/grader/sandbox_init.c.o: $(SANDBOX_INIT)

$(OUT)/libgrader.a: $(call objects,$(GRADER_SOURCES) tests/probes/sections.c)
	@rm -f $@
	@ar rcs $@ $^

# What knows the answers: never in a handout as text, and never linked with what starts a student's code.
JUDGE_SOURCES := $(filter-out tests/judge/judge_tool.c,$(wildcard $(addsuffix /*.c,$(JUDGE_FOLDERS))))
$(OUT)/libjudge.a: $(call objects,$(JUDGE_SOURCES) $(BUILDERS))
	@rm -f $@
	@ar rcs $@ $^

# What the judge needs besides: no file is read by it, no device opened.
JUDGE_NEEDS = $(addprefix common/,$(addsuffix .c,cl_check clean_text complain image number scene2d \
    scene2d_edge_cases scene2d_random scene3d scene3d_edge_cases scene3d_lattice scene3d_random \
    scene3d_sphereflake scene3d_view scene_arguments tree2d tree2d_draw tree3d tree3d_draw)) \
    $(addprefix tests/,grader/message.c grader/result.c judge/judge_tool.c probes/sections.c)
ifneq ($(wildcard tests/judge/judge_tool.c),)
# Linked statically: it runs wherever a handout that holds it is unpacked.
$(OUT)/tools/judge: $(call objects,$(JUDGE_NEEDS)) $(OUT)/libjudge.a
	@mkdir -p $(@D)
	$(call say,link    $@)$(CC) $(or $(SANITIZERS),-static) $(LDFLAGS) $^ -lm -o $@

# The same for handouts, which go to machines of both kinds, stripped: judge-x86_64, judge-aarch64.
.PHONY: judge always
judge: $(OUT)/tools/judge
$(OUT)/judges/judge-%: always
	@command -v $*-linux-gnu-gcc >/dev/null || { \
	    echo "make: found no $*-linux-gnu-gcc, expected one: make handout installs it" >&2; exit 2; }
	@$(MAKE) --no-print-directory BUILD=$(OUT)/judges/$* CC=$*-linux-gnu-gcc OPTIMISATION='-O2 -flto=auto' LDFLAGS=-s judge
	@cp $(OUT)/judges/$*/tools/judge $@
else
# In a handout.
$(OUT)/tools/judge: tests/judge/judge-$(shell uname -m)
	@mkdir -p $(@D)
	@cp $< $@
endif

$(OUT)/tools/grade $(OUT)/tools/memcheck: $(OUT)/tools/%: $(OUT)/obj/tests/grader/%.c.o $(OUT)/libgrader.a $(OUT)/libcommon.a | $(CODEC)
	@mkdir -p $(@D)
	$(call say,link    $@)$(CC) $(SANITIZERS) $^ $(LIBRARIES) -o $@

# Known answers to the tasks, and mechanical ones, through the grader.
$(OUT)/libmutation.a: $(call objects,tests/mutation/mistake_kinds.c tests/mutation/mutations.c)
	@rm -f $@
	@ar rcs $@ $^

$(OUT)/tools/mutants $(OUT)/tools/mutate: $(OUT)/tools/%: $(OUT)/obj/tests/mutation/%.c.o $(OUT)/libmutation.a $(OUT)/libgrader.a $(OUT)/libcommon.a | $(CODEC)
	@mkdir -p $(@D)
	$(call say,link    $@)$(CC) $(SANITIZERS) $^ $(LIBRARIES) -o $@

# A class: the roster of who handed in, and the gradebook.
CLASS_SOURCES := $(filter-out %_tool.c,$(wildcard tests/class/*.c))
$(OUT)/libclass.a: $(call objects,$(CLASS_SOURCES))
	@rm -f $@
	@ar rcs $@ $^

$(OUT)/tools/gradebook: $(call objects,tests/class/gradebook_tool.c) $(OUT)/libclass.a $(OUT)/libgrader.a $(OUT)/libcommon.a
	@mkdir -p $(@D)
	$(call say,link    $@)$(CC) $(SANITIZERS) $^ $(LIBRARIES) -lnettle -o $@

# The only program that reads archives of students, in the sandbox.
$(OUT)/tools/unpack: $(OUT)/obj/tests/grader/unpack_tool.c.o $(OUT)/libgrader.a $(OUT)/libcommon.a
	@mkdir -p $(@D)
	$(call say,link    $@)$(CC) $(SANITIZERS) $^ -larchive -o $@

# One probe a lab: an archive for labs with host files, which the grader links with the student's, and
# a program for the others.
PROBES := $(patsubst tests/probes/%/main.c,%,$(wildcard tests/probes/*/main.c))
# The host files that students hand in; a lab may have given ones besides.
host_files = $(shell grep -o '"[a-zA-Z0-9_]*\.c"' labs/$(1)/lab.json)
define probe
$(OUT)/obj/tests/probes/$(1)/main.c.o: EXTRA = -I tests/probes -I labs/$(1) \
    -DLAB_NAME='"$(1)"' -DLAB_FOLDER='"labs/$(1)"' -DPROBE_KERNEL_OPTIONS='"$(call include_path,$(1))"'
$(OUT)/probes/$(1).a: $(call objects,tests/probes/$(1)/main.c tests/probes/probe.c tests/probes/sections.c)
	@mkdir -p $$(@D)
	@rm -f $$@
	@ar rcs $$@ $$^
$(OUT)/probes/$(1): $(OUT)/probes/$(1).a $(OUT)/libcommon.a
	$$(call say,link    $$@)$(CC) $(SANITIZERS) $$^ -lOpenCL -lm -o $$@
PROBE_TARGETS += $(OUT)/probes/$(1).a $(if $(call host_files,$(1)),,$(OUT)/probes/$(1))
endef
$(foreach l,$(PROBES),$(eval $(call probe,$(l))))

.PHONY: grader
grader: $(if $(HANDOUT),,$(addprefix $(OUT)/tools/,holes gradebook mutants mutate)) $(addprefix $(OUT)/tools/,judge grade memcheck unpack) $(PROBE_TARGETS) $(foreach l,$(LABS),$(OUT)/earlier/$(l).a)  ## build the grader and its probes

# The same for one lab: what a bundle for another system builds.
.PHONY: lab-grader
lab-grader: $(addprefix $(OUT)/tools/,grade judge unpack) $(filter $(OUT)/probes/$(LAB)-%,$(PROBE_TARGETS)) $(patsubst %,$(OUT)/earlier/%.a,$(filter $(LAB)-%,$(LABS)))

# Status 1 is a verdict, such as points that are missing: make has nothing to complain of.
verdict_is_no_fault = || test $$? -eq 1

.PHONY: grade
grade: grader  ## grade LAB=03 [SUBMISSION=folder or archive] [SEED=n] [DEVICE=d] [TIME_LIMIT=seconds] [FORMAT=junit,tap]
	@test -n "$(LAB)" || { echo "make grade: say which lab: make grade LAB=$(EXAMPLE_LAB)" >&2; exit 2; }
	@$(OUT)/tools/grade --build $(OUT) --lab "$$LAB" $(if $(SUBMISSION),--submission "$$SUBMISSION") \
	    $(if $(SEED),--seed "$$SEED") $(if $(DEVICE),--device "$$DEVICE") \
	    $(if $(TIME_LIMIT),--time-limit "$$TIME_LIMIT") \
	    $(if $(FORMAT),--format "$$FORMAT") $(verdict_is_no_fault)

.PHONY: memcheck
memcheck: grader  ## look for indices out of range, unset values and races: LAB=03 [SUBMISSION=folder]
	@test -n "$(LAB)" || { echo "make memcheck: say which lab: make memcheck LAB=$(EXAMPLE_LAB)" >&2; exit 2; }
	@$(OUT)/tools/memcheck --build $(OUT) --lab "$$LAB" \
	    $(if $(SUBMISSION),--submission "$$SUBMISSION") $(if $(SEED),--seed "$$SEED") \
	    $(if $(TIME_LIMIT),--time-limit "$$TIME_LIMIT") $(verdict_is_no_fault)

ifndef HANDOUT
# Bundles for the systems that courses use (tests/systems/README.md), in build/systems.
.PHONY: gradescope autolab prairielearn github
gradescope:  ## the autograder of LAB=03 for Gradescope
autolab:  ## the assessment of LAB=03 for Autolab
prairielearn:  ## the question of LAB=03 for PrairieLearn, and its grader's image
github:  ## the workflow of LAB=03 for GitHub Classroom
gradescope autolab prairielearn github:
	@test -n "$(LAB)" || { echo "make $@: say which lab: make $@ LAB=03" >&2; exit 2; }
	@tests/systems/bundle.sh $@ "$$LAB" $(BUILD)/systems

.PHONY: grade-class
grade-class: grader  ## grade a class: LAB=03 SUBMISSIONS=folder [OUTPUT=folder] [ENGINE=slurm] [SEED=n] [ONLY=failed|latest] [JOBS=n] [TIME_LIMIT=seconds] [AGAIN=1] [MOODLE=file.csv] [AGAINST=gradebook.json]
	@tests/class/grade_class.sh --build $(OUT) --lab "$(LAB)" --submissions "$$SUBMISSIONS" \
	    $(if $(OUTPUT),--output "$$OUTPUT") $(if $(ENGINE),--engine "$$ENGINE") \
	    $(if $(SEED),--seed "$$SEED") $(if $(ONLY),--only "$$ONLY") $(if $(JOBS),--jobs "$$JOBS") \
	    $(if $(AGAIN),--again "$$AGAIN") $(if $(MOODLE),--moodle "$$MOODLE") \
	    $(if $(AGAINST),--against "$$AGAINST") $(if $(DEVICE),--device "$$DEVICE") \
	    $(if $(TIME_LIMIT),--time-limit "$$TIME_LIMIT")

# What a message needs, for tools that need little else of common/.
MESSAGES = common/complain.c common/clean_text.c

# ---- Skeletons: labs/ is cut from solutions/ ------------------------------------------------

$(OUT)/tools/holes: $(call objects,tests/holes_tool.c tests/grader/holes.c tests/grader/message.c \
    common/text_file.c $(MESSAGES))
	@mkdir -p $(@D)
	$(call say,link    $@)$(CC) $(SANITIZERS) $^ -o $@

.PHONY: skeletons
skeletons: $(OUT)/tools/holes  ## for authors: cut labs/ anew from solutions/; the old one goes to build/labs-replaced
	@if [ -d labs ]; then rm -rf $(BUILD)/labs-replaced && cp -r labs $(BUILD)/labs-replaced; fi
	@tests/cut_labs.sh $(OUT)/tools/holes labs

# ---- Handouts -------------------------------------------------------------------------------

JUDGES = $(addprefix $(OUT)/judges/judge-,x86_64 aarch64)
.PHONY: handout pack
handout:  ## install what is missing, pack what students get: LAB=03
	@test -n "$(LAB)" || { echo "make handout: say which lab: make handout LAB=03" >&2; exit 2; }
	@common/setup/install.sh handout
	@$(MAKE) --no-print-directory -j2 pack
pack: $(OUT)/tools/holes grader $(JUDGES)
	@tests/handout/pack.sh $(OUT)/tools "$$LAB" $(OUT)/handout

# ---- Tests ----------------------------------------------------------------------------------

UNIT_TESTS := $(patsubst tests/unit/%.c,$(OUT)/tests/%,$(wildcard tests/unit/test_*.c))
$(UNIT_TESTS): $(OUT)/tests/%: $(OUT)/obj/tests/unit/%.c.o $(OUT)/libclass.a $(OUT)/libmutation.a $(OUT)/libgrader.a $(OUT)/libjudge.a $(OUT)/libcommon.a | $(CODEC)
	@mkdir -p $(@D)
	$(call say,link    $@)$(CC) $(SANITIZERS) $(filter %.o,$^) -Wl,--start-group $(filter %.a,$^) -Wl,--end-group $(LIBRARIES) -larchive -lnettle -lcriterion -o $@

# Fuzz targets, each as a function of its name, for the test that runs their corpus through.
$(OUT)/obj/tests/fuzz/%.c.o: EXTRA = $(GRADER_INCLUDES) -DLLVMFuzzerTestOneInput=$(notdir $*)
$(OUT)/obj/tests/unit/test_corpus.c.o: EXTRA = $(GRADER_INCLUDES) -I tests/fuzz
$(OUT)/tests/test_corpus: $(call objects,$(wildcard tests/fuzz/fuzz_*.c))

# The figures that the bench prints.
$(OUT)/obj/tests/unit/test_bench_report.c.o: EXTRA = -I tests/bench
$(OUT)/tests/test_bench_report: $(call objects,tests/bench/report.c tests/bench/series.c)

# Lab 02's builder with a distribute() that returns more circles than it was given.
TOO_MANY = $(OUT)/wrong/returns-too-many.c
$(TOO_MANY): solutions/02-kdtree-2d-build/kdtree2d_build.c \
    tests/mutants/02-kdtree-2d-build/returns-too-many.c $(OUT)/tools/holes
	@mkdir -p $(@D)
	@$(OUT)/tools/holes fill $< distribute $(word 2,$^) >$@.new && mv $@.new $@
$(OUT)/obj/tests/unit/test_builder_guard.c.o: EXTRA = $(GRADER_INCLUDES) -I $(dir $(TOO_MANY))
$(OUT)/obj/tests/unit/test_builder_guard.c.o: $(TOO_MANY)

# What the suites use: a comparison of two pictures, what rays hit, and a device without images.
$(OUT)/tools/compare: $(call objects,tests/compare.c) $(OUT)/libcommon.a | $(CODEC)
	@mkdir -p $(@D)
	$(call say,link    $@)$(CC) $(SANITIZERS) $^ $(LIBRARIES) -o $@

$(OUT)/tools/count_hits: $(call objects,tests/count_hits.c) $(OUT)/libgrader.a $(OUT)/libjudge.a $(OUT)/libcommon.a | $(CODEC)
	@mkdir -p $(@D)
	$(call say,link    $@)$(CC) $(SANITIZERS) -Wl,--start-group $^ -Wl,--end-group $(LIBRARIES) -o $@

# What the attacks meet: a listener that must not be reached, and a wrapper that sees survivors.
$(OUT)/tools/listener $(OUT)/tools/left_behind: $(OUT)/tools/%: tests/%.c
	@mkdir -p $(@D)
	$(call say,link    $@)$(CC) $(CFLAGS) $< -o $@

# A kernel without Landlock and namespaces.
$(OUT)/tools/older_kernel: tests/older_kernel.c
	@mkdir -p $(@D)
	$(call say,link    $@)$(CC) $(CFLAGS) $< -lseccomp -o $@

$(OUT)/tests/no_images.so: tests/no_images.c
	@mkdir -p $(@D)
	$(call say,link    $@)$(CC) $(CFLAGS) -fPIC -shared $< -ldl -o $@

# Unit tests run under the sanitizers, but for this one: PoCL's compiler is not built for them.
NATIVE_TEST = $(OUT)/tests/test_cl_setup

.PHONY: unit-tests
unit-tests: $(filter-out $(NATIVE_TEST),$(UNIT_TESTS))

.PHONY: tests
tests: all $(NATIVE_TEST) $(JUDGES) $(OUT)/tools/compare $(OUT)/tools/count_hits $(OUT)/tests/no_images.so $(OUT)/tools/listener $(OUT)/tools/left_behind $(OUT)/tools/older_kernel  ## build all that the tests run
	@$(MAKE) --no-print-directory SANITIZE=1 all unit-tests

.PHONY: check
check: tests  ## run the tests without installing anything
	@BUILD="$(BUILD)" tests/run.sh

.PHONY: test
test:  ## install what is missing and run every test
	@common/setup/install.sh test
	@$(MAKE) --no-print-directory -j2 check

.PHONY: test-scale test-mutants test-attacks
test-scale:  ## install what is missing, grade a class of N=1000, try mechanical mutants of every lab (long)
	@common/setup/install.sh test
	@common/setup/install.sh scale
	@$(MAKE) --no-print-directory -j2 grader
	@BUILD="$(BUILD)" tests/run.sh slurm
	@tests/scale/run.sh $(or $(N),1000) $(OUT)
	@$(MAKE) --no-print-directory test-mutants
	@$(MAKE) --no-print-directory test-attacks

test-mutants: grader  ## try mechanical mutants of every lab, or of LAB=03 (long)
	@tests/mutate.sh $(OUT) $(LAB)

test-attacks: tests  ## try every attack in every sandbox, as root (long)
	@BUILD="$(BUILD)" SANDBOXES="bubblewrap landlock user user-unfiltered" \
	    sh tests/suites/attacks.sh tests/attacks/*/*

# What libFuzzer feeds, compiled by clang together with the target: a list for each tests/fuzz/fuzz_*.c.
CLANG ?= $(firstword $(foreach c,clang clang-19 clang-15 clang-14,$(shell command -v $(c))))
SECONDS ?= 60
FUZZED_graded = $(addprefix tests/grader/,graded.c result.c message.c) common/image.c $(MESSAGES)
FUZZED_manifest = tests/grader/manifest.c tests/grader/message.c $(MESSAGES)
FUZZED_scene3d = $(wildcard common/scene3d*.c common/molecule*.c) $(MESSAGES) \
    $(addprefix common/,elements.c line_reader.c number.c scene_arguments.c text_file.c)
FUZZED_sections = tests/probes/sections.c
FUZZED_source = $(addprefix tests/grader/,source_words.c stands_out.c extra_files.c holes.c) common/text_file.c $(MESSAGES)
FUZZED_unpack = $(addprefix tests/grader/,unpack.c unpack_entry.c file_kind.c bytes_write.c places.c \
    stage.c message.c) $(MESSAGES)
FUZZ_TARGETS := $(patsubst tests/fuzz/fuzz_%.c,fuzz-%,$(wildcard tests/fuzz/fuzz_*.c))

.PHONY: fuzz $(FUZZ_TARGETS)
fuzz: $(if $(TARGET),fuzz-$(TARGET),$(FUZZ_TARGETS))  ## for authors: fuzz what reads files, [TARGET=unpack] for SECONDS=60 each (needs libclang-rt-dev)

$(FUZZ_TARGETS): fuzz-%:
	@mkdir -p $(BUILD)/fuzz/$*/new
	$(CLANG) -std=c11 -D_GNU_SOURCE -O1 -g -fsanitize=fuzzer,address,undefined \
	    -fno-sanitize-recover=undefined $(INCLUDES) $(GRADER_INCLUDES) tests/fuzz/fuzz_$*.c \
	    $(FUZZED_$*) -larchive -ljansson -lm -o $(BUILD)/fuzz/$*/fuzz
	$(BUILD)/fuzz/$*/fuzz $(addprefix -dict=,$(wildcard tests/fuzz/$*.dict)) -max_len=4096 \
	    -max_total_time=$(SECONDS) -artifact_prefix=$(BUILD)/fuzz/$*/ $(FUZZ_OPTIONS) \
	    $(BUILD)/fuzz/$*/new tests/fuzz/corpus/$*

# ---- The bench ------------------------------------------------------------------------------

# Embree, which the 3D bench compares with where its package is installed: version 4, or 3.
EMBREE := $(firstword $(foreach v,4 3,$(if $(wildcard /usr/include/embree$(v)/rtcore.h),$(v))))
BENCH_INCLUDES = $(BUILDER_INCLUDES) -I solutions/05-spheres
$(OUT)/obj/tests/bench/%.o: EXTRA = $(BENCH_INCLUDES) \
    -DNAIVE_OPTIONS='"$(call include_path,01-naive-2d)"' \
    -DKDTREE_OPTIONS='"$(call include_path,03-kdtree-2d-render)"' \
    -DSPHERES_OPTIONS='"$(call include_path,05-spheres)"' \
    -DTRACE_OPTIONS='"$(call include_path,07-kdtree-3d-trace)"'
# For this machine, as OpenCL compiles the kernels; anew when Embree was installed since.
$(OUT)/obj/tests/bench/embree_peer.c.o: EXTRA = $(BENCH_INCLUDES) -O3 -march=native \
    $(if $(EMBREE),-DWITH_EMBREE=$(EMBREE))
$(OUT)/obj/tests/bench/embree_peer.c.o: $(OUT)/embree-version
$(OUT)/embree-version: always
	@mkdir -p $(@D)
	@echo "$(EMBREE)" | cmp -s - $@ || echo "$(EMBREE)" >$@

$(OUT)/libbench.a: $(call objects,$(filter-out tests/bench/bench%d.c,$(wildcard tests/bench/*.c)) \
    $(BUILDERS) solutions/05-spheres/scene_buffers.c)
	@rm -f $@
	@ar rcs $@ $^

$(OUT)/tools/bench2d $(OUT)/tools/bench3d: $(OUT)/tools/%: $(OUT)/obj/tests/bench/%.c.o $(OUT)/libbench.a $(OUT)/libcommon.a
	@mkdir -p $(@D)
	$(call say,link    $@)$(CC) $(SANITIZERS) $^ $(LIBRARIES) $(if $(EMBREE),-lembree$(EMBREE)) -pthread -o $@

.PHONY: bench
bench:  ## install what is missing, measure naive against kd-tree in 2D and 3D, plot to build/bench
	@common/setup/install.sh bench
	@$(MAKE) --no-print-directory $(OUT)/tools/bench2d $(OUT)/tools/bench3d
	@for bench in bench2d bench3d; do \
	    $(OUT)/tools/$$bench --output $(OUT)/bench $(if $(DEVICE),--device "$$DEVICE") \
	        $(if $(ROUNDS),--rounds "$$ROUNDS") && \
	    gnuplot -e "folder='$(OUT)/bench'" tests/bench/$$bench.gnuplot && \
	    echo "The plot: $(OUT)/bench/$$bench.png and .svg" || exit 1; done

endif  # HANDOUT

# ---- For people -----------------------------------------------------------------------------

.PHONY: setup
setup:  ## install what building and grading need, where it is missing
	@common/setup/install.sh demo

ifndef HANDOUT
.PHONY: demo
demo:  ## install what is missing, render every solution, grade a small class
	@common/setup/install.sh demo
	@$(MAKE) --no-print-directory -j2 all
	@tests/demo.sh $(OUT)

.PHONY: figures
figures: all  ## draw the pictures of the READMEs and notes anew
	tests/figures.sh slides-notes/figures $(OUT) >/dev/null

.PHONY: format
format:  ## put every source into the one format
	clang-format-19 -i $$(git ls-files -- '*.c' '*.h' '*.cpp' '*.cl' | grep -v -e ^labs/ -e ^tests/stand_ins/ -e ^tests/mutants/ -e ^tests/right/ -e ^tests/memcheck/ -e ^tests/attacks/)

endif  # HANDOUT

# Make looks into folders once, at its start: what is cleaned then cannot be built in the same run.
ifneq ($(and $(filter clean,$(MAKECMDGOALS)),$(filter-out clean,$(MAKECMDGOALS))),)
$(error make clean stands alone: run it first, then make $(filter-out clean,$(MAKECMDGOALS)))
endif

.PHONY: clean
clean:  ## remove everything that was made
	rm -rf "$(BUILD)"

.PHONY: help
# In a handout of a lab without kernels there is nothing to look into.
NOT_HERE = $(if $(HANDOUT),$(if $(wildcard labs/*/*.cl),,memcheck))
help:  ## print this list
	@awk -F ':.*## ' '$$1 == "$(NOT_HERE)" { next } /^ifndef HANDOUT/ { hidden = "$(HANDOUT)" } /^endif  # HANDOUT/ { hidden = "" } \
	    !hidden && /^[a-z-]+:.*## / { sub("LAB=03", "LAB=$(EXAMPLE_LAB)"); printf "  make %-12s %s\n", $$1, $$2 }' $(firstword $(MAKEFILE_LIST))

-include $(shell find $(OUT)/obj -name '*.d' 2>/dev/null)
