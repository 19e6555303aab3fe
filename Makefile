# From circles to rays: build, draw, grade. `make help` lists the targets.
# Everything that is made goes under build/. A new folder in solutions/ needs no edit here. How the
# grader is built stands in tests/grader/grader.mk, what only authors need in tests/tests.mk.

# Text from outside is data for make, too. What a user sets, on the command line or in the environment, may
# hold a student's file name, such as x$(shell id).zip, and make would run what is in it. So each such
# variable is taken as it is written, before anything reads it. Recipes get it from the environment, as
# "$$NAME"; a makefile only asks whether it is set, $(if $(NAME),...), or picks a name of ours with it,
# $(filter $(NAME),...). The suite static looks for a variable that is missing here.
FROM_OUTSIDE := LAB SUBMISSION TASK ALL SEED DEVICE TIME_LIMIT FORMAT AT OPTIONS SOLUTION SUBMISSIONS OUTPUT ENGINE ONLY JOBS \
    AGAIN JSON LIST COLUMN MOODLE HIDE THROTTLE WHO CHANGES POINTS DUE LATE FOR AGAINST NOTHING CLASSES EXPORT PASS NEED EXCEL NAMES ROUNDS N ORDER \
    TARGET SECONDS V SANITIZE BUILD
# Whoever sets these names commands: they are the only ones that become text of a recipe.
FROM_OUTSIDE += CLANG LDFLAGS FUZZ_OPTIONS
is_from_outside = $(or $(findstring command,$(origin $(1))),$(and $(filter $(1),$(FROM_OUTSIDE)),$(findstring environment,$(origin $(1)))))
$(foreach name,$(.VARIABLES),$(if $(call is_from_outside,$(name)),$(eval \
    $(if $(filter-out environment,$(origin $(name))),override) export $(name) := $$(value $(name)))))

# In a Turkish locale [a-z] of grep and sed has no i: our tools speak no language. $(shell) does not see this.
export LC_ALL := C.UTF-8

BUILD ?= build
# A path in rules and recipes.
SIGNS := $$ ` " ' \ ; & | < > ( ) [ ] * ? ~ ! : % = \#
ifneq ($(word 2,$(BUILD))$(strip $(foreach sign,$(SIGNS),$(findstring $(sign),$(BUILD)))),)
$(error BUILD: found "$(BUILD)", expected the path of a folder without blanks and signs of the shell)
endif
CC = gcc
CXX = g++
OPTIMISATION = -O2 -g
WARNINGS = -Wall -Wextra -Werror
INCLUDES = -Icommon -Ikernels
# `make SANITIZE=1` builds the same with the address and undefined sanitizers, in a folder of its own.
ifeq ($(SANITIZE),1)
OUT := $(BUILD)/sanitized
SANITIZERS = -fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer
else
OUT := $(BUILD)
endif
# GCC 12 forgets to round two neighbours, as x and y of a vector, that go from double to float and back:
# its vectoriser of straight code takes the two conversions out. Then a seed's inputs differ by machine.
ROUNDING = -fno-tree-slp-vectorize
CFLAGS = -std=c11 -D_GNU_SOURCE $(OPTIMISATION) $(ROUNDING) $(WARNINGS) $(SANITIZERS)
CXXFLAGS = -std=c++17 $(OPTIMISATION) $(WARNINGS) $(SANITIZERS)
# The linker drops those that a program does not use (--as-needed). pkg-config is asked only when
# something is made, so that `make demo` can install it first. RPATH and not RUNPATH, at which the
# address sanitizer's dlopen() does not look.
LIBRARIES = -Wl,--as-needed,--disable-new-dtags,-rpath,'$$ORIGIN/..' $(shell pkg-config --libs jansson) -lcsv -lseccomp -lOpenCL -lm

# What every compilation waits for: files with flags, and a machine that can compile.
FLAG_FILES := Makefile $(wildcard tests/grader/grader.mk tests/judge/judge.mk) | $(BUILD)/ready
$(BUILD)/ready:
	@common/setup/ready.sh "$@" "$(CC)" "$(CXX)"

.DELETE_ON_ERROR:
.SECONDARY:
# Prerequisites are expanded twice: $$* is the target's %, which the first time does not know.
.SECONDEXPANSION:
.DEFAULT_GOAL := all
# Of make's own rules none is used; one would make 01.d, a list of headers, of 01.d.o.
MAKEFLAGS += --no-builtin-rules
# As many at a time as there are processors, where the command line does not say how many.
ifeq ($(MAKELEVEL)$(filter -j%,$(MAKEFLAGS)),0)
MAKEFLAGS += -j$(shell nproc)
endif
# `make V=1` shows whole commands.
say = $(if $(V),,@echo "  $(1)" && )
objects = $(patsubst %,$(OUT)/obj/%.o,$(sort $(1)))
# Three recipes: an object, which is as old as the moment in which its compiler began, so that a header that is
# saved while it runs is newer; an archive of all objects that its target depends on; a program of all objects and archives.
define compile  # COMPILER AND FLAGS, for whom
	@{ [ -d $(@D) ] || mkdir -p $(@D); } && : >$@.begun
	$(call say,compile $<$(2))$(1) -MMD -MP $(INCLUDES) $(EXTRA) -c $< -o $@ && touch -r $@.begun $@
endef
archive = @mkdir -p $(@D) && rm -f $@ && $(AR) rcs $@ $(filter %.o,$^)
define link  # LIBRARIES
	@mkdir -p $(@D)
	$(call say,link    $@)$(CC) $(SANITIZERS) $(LDFLAGS) $(filter %.o,$^) -Wl,--start-group $(filter %.a,$^) -Wl,--end-group $(1) -o $@
endef

# ---- Labs -----------------------------------------------------------------------------------

LABS := $(sort $(notdir $(patsubst %/lab.json,%,$(wildcard labs/*/lab.json solutions/*/lab.json))))
PROGRAMS := $(patsubst %/lab.json,$(OUT)/%,$(wildcard labs/*/lab.json solutions/*/lab.json))
.PHONY: all
all: $(PROGRAMS) grader  ## build every lab, every solution and the grader

# The labs before lab $(1), those whose names sort before it: for 02 they are 00 and 01. What they
# deliver comes from their solutions: every file but main.c.
earlier = $(foreach lab,$(LABS),$(if $(filter $(1),$(firstword $(sort $(1) $(lab)))),,$(lab)))
earlier_sources = $(foreach lab,$(call earlier,$(1)),$(filter-out %/main.c,$(wildcard solutions/$(lab)/*.c)))
# Where headers and kernels of lab $(1) are looked for, after its own folder.
include_path = -I kernels $(addprefix -I solutions/,$(call earlier,$(1)))

# A lab's files stand in labs/NAME or solutions/NAME. What a student has half written may have warnings.
lab_name = $(notdir $(<D))
$(OUT)/obj/labs/%.o $(OUT)/obj/solutions/%.o: EXTRA = -I $(<D) $(call include_path,$(lab_name)) \
    -DLAB_NAME='"$(lab_name)"' -DLAB_FOLDER='"$(<D)"' -DKERNEL_OPTIONS='"$(call include_path,$(lab_name))"'
$(OUT)/obj/labs/%.o: WARNINGS = -Wall -Wextra
# Lab 08 builds a tree in half the time where what its loops call is compiled into them.
$(OUT)/obj/labs/%.o $(OUT)/obj/solutions/%.o: OPTIMISATION = -O3 -g

# A program is made of its lab's files and of what the linker takes from the labs before and from common/.
$(PROGRAMS): $(OUT)/%: $$(call objects,$$(wildcard $$*/*.c)) $(OUT)/earlier/$$(notdir $$*).a $(OUT)/libcommon.a | $(OUT)/libimage_codec.so
	$(call link,$(LIBRARIES))
$(OUT)/earlier/%.a: $$(call objects,$$(call earlier_sources,$$*)) | $(BUILD)/ready
	$(archive)
$(OUT)/labs/% $(OUT)/solutions/%:
	@printf 'make: found no lab for %s, expected %s\n' '$(subst ','\'',$@)' '$(filter $(@D)/%,$(PROGRAMS))' >&2; exit 2

# ---- Common ---------------------------------------------------------------------------------

# When a flag changes, here or in the grader's or the judge's file, everything is compiled anew.
$(OUT)/obj/%.c.o: %.c $(FLAG_FILES)
	$(call compile,$(CC) $(CFLAGS))
$(OUT)/obj/%.cpp.o: %.cpp $(FLAG_FILES)
	$(call compile,$(CXX) $(CXXFLAGS) $(shell pkg-config --cflags OpenImageIO) -fPIC)
$(OUT)/libcommon.a: $(call objects,$(wildcard common/*.c))
	$(archive)
# Loaded by whatever reads or writes a picture, from the folder above the program (image_codec.h).
$(OUT)/libimage_codec.so: $(call objects,common/image.cpp)
	$(call say,link    $@)$(CXX) $(SANITIZERS) -shared $^ $(shell pkg-config --libs OpenImageIO) -o $@

# ---- For people -----------------------------------------------------------------------------

.PHONY: setup doctor help clean
setup:  ## install what building, grading and make view need, as root or through sudo
	@common/setup/install.sh $(setup_for) view

doctor:  ## look at this machine, and name one command for each thing that is wrong [JSON=1]
	@common/setup/doctor.sh --for $(setup_for) $(if $(JSON),--json)

# One pixel; windows; the grader; and, where they are, its judge, memcheck, all that is for authors,
# and the notes. A handout has not all of it.
include common/follow/follow.mk common/view/view.mk tests/grader/grader.mk
-include tests/native/native.mk tests/desk/desk.mk tests/judge/judge.mk tests/memcheck/memcheck.mk tests/tests.mk slides-notes/make/notes.mk

# Make lists the sources and what is built once, when it starts: after a clean in the same run it would not know.
ifneq ($(and $(filter clean,$(MAKECMDGOALS)),$(filter-out clean,$(MAKECMDGOALS))),)
$(error make clean stands alone: run it first, then make $(filter-out clean,$(MAKECMDGOALS)))
endif
clean:  ## remove everything that was made: build/, with the grades of classes there
	rm -rf "$(BUILD)"

# In examples: a lab that is there.
EXAMPLE_LAB := $(if $(wildcard labs/03-*),03,$(firstword $(subst -, ,$(notdir $(wildcard labs/[0-9]*)))))
# In a handout it lists what its one lab has.
here := $(wildcard labs/*/lab.json)
has_not = $(if $(word 2,$(here)),,$(if $(filter $(here),$(FOLLOWED:%=labs/%/lab.json)),,pixel) $(if $(filter $(here),$(SEEN:%=labs/%/lab.json)),,view movie))
help:  ## print this list
	@printf '  %-17s %s\n' "make build/labs/$(notdir $(firstword $(wildcard labs/$(EXAMPLE_LAB)-*)))" "one lab's program; V=1 shows whole commands; SANITIZE=1 build/sanitized/labs/... looks for faults in memory"
	@awk -F ':.*## ' '/^[a-z-]+:.*## / && " $(has_not) " !~ " " $$1 " " { sub("LAB=03", "LAB=$(EXAMPLE_LAB)"); \
	    $(if $(word 2,$(here)),,sub(/ \[SOLUTION=1\]/, ""); sub(/, with the grades of classes there/, ""); ) printf "  make %-12s %s\n", $$1, $$2 }' $(filter %Makefile %.mk,$(MAKEFILE_LIST))

-include $(shell find $(OUT)/obj $(OUT)/native/obj $(OUT)/memcheck/obj -name '*.d' 2>/dev/null)
