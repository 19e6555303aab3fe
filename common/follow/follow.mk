# How a lab's pixel is followed: a library that the windows use, too (common/view), and a program a lab,
# `make pixel`.

# Labs with something to see, and those of them whose pixels can be followed: each has a file of its name.
SEEN := $(filter $(patsubst common/follow/%.c,%,$(wildcard common/follow/[0-9]*.c)),$(LABS))
FOLLOWED := $(filter $(patsubst common/follow/steps/%.cl,%,$(wildcard common/follow/steps/[0-9]*.cl)),$(SEEN))
# programs_of FOLDER,LABS: of students and solutions.
programs_of = $(foreach lab,$(2),$(patsubst %/lab.json,$(OUT)/$(1)/%,$(wildcard labs/$(lab)/lab.json solutions/$(lab)/lab.json)))
PIXELS := $(call programs_of,pixel,$(FOLLOWED))

# What every lab's is made of.
PIXEL_SOURCES := common/follow/pixel.c
$(OUT)/obj/common/follow/%.o: EXTRA = -I common/follow
$(OUT)/libfollow.a: $(call objects,$(filter-out $(addprefix common/follow/,eye.c rays.c spheres.c) $(PIXEL_SOURCES),$(wildcard common/follow/[a-z]*.c)))
	$(archive)

# And what is of its lab: a file of its own, the lab's host files but main.c, and in 3D eye.c, which needs
# lab 04's camera, with rays.c there, and from lab 05 on, whose buffers it uses, with spheres.c.
brings = $(wildcard $(addsuffix /$(2),labs/$(1) solutions/$(1) $(addprefix solutions/,$(call earlier,$(1)))))
follow_parts = $(1) $(if $(call brings,$(1),scene_buffers.h),eye spheres,$(if $(call brings,$(1),camera_from_view.h),eye rays))
follow_objects = $(patsubst %,$(OUT)/obj/follow/$(1)/%.o,$(call follow_parts,$(notdir $(1)))) \
    $(call objects,$(filter-out %/main.c,$(wildcard $(1)/*.c)))
followed_lab = $(patsubst $(OUT)/obj/follow/%/,%,$(dir $@))
$(OUT)/obj/follow/%.o: EXTRA = -I common/follow -I $(followed_lab) $(call include_path,$(notdir $(followed_lab))) \
    -DLAB_NAME='"$(notdir $(followed_lab))"' -DLAB_FOLDER='"$(followed_lab)"' -DSTEPS_FOLDER='"common/follow/steps"' \
    -DKERNEL_OPTIONS='"$(call include_path,$(notdir $(followed_lab)))"'
$(OUT)/obj/follow/%.o: common/follow/$$(notdir $$*).c $(FLAG_FILES)
	$(call compile,$(CC) $(CFLAGS), for $(followed_lab))

# The reference knows the answers: it is not in a handout, where no_reference.c stands in its place.
REFERENCE := $(wildcard tests/follow/*.c)
$(OUT)/obj/tests/follow/%.o: EXTRA = $(GRADER_INCLUDES) -I common/follow
$(PIXELS): LIBRARIES += -Wl,-rpath,'$$ORIGIN/../..'
$(PIXELS): $(OUT)/pixel/%: $(call objects,$(PIXEL_SOURCES) $(REFERENCE)) $$(call follow_objects,$$*) $(OUT)/libfollow.a \
    $(OUT)/earlier/$$(notdir $$*).a $(if $(REFERENCE),$(OUT)/libjudge.a) $(OUT)/libcommon.a | $(OUT)/libimage_codec.so
	$(call link,$(LIBRARIES))

# The student's own; with SOLUTION=1 the solution.
own_program = $(OUT)/$(1)/$(if $(SOLUTION),solutions,labs)/$(graded_lab)
only_solved = $(filter-out $(patsubst labs/%/lab.json,%,$(wildcard labs/*/lab.json)),$(1))
and_solved = $(or $(1),there is none here)$(if $(only_solved),; add SOLUTION=1 for those that are here as a solution only)
has_none = $(if $(filter-out $(1),$(graded_lab)),echo 'make $@: $(graded_lab) has no $(2). $(if $(1),These labs have one: $(and_solved),No lab here has one)' >&2; exit 2;)
is_one_of = test -n "$(filter $(graded_lab),$(1))" || { $(has_none) printf 'make $@: found LAB="%s", expected a lab that has a $(2): %s\n' \
    "$$LAB" '$(and_solved)' >&2; exit 2; }; \
    test -n "$(wildcard $(if $(SOLUTION),solutions,labs)/$(graded_lab)/lab.json)" || { \
    echo 'make $@: $(if $(SOLUTION),there is no solution of $(graded_lab) here: leave SOLUTION=1 out,$(graded_lab) is here as a solution only: add SOLUTION=1)' >&2; exit 2; }
# PROGRAM with the words of OPTIONS behind it: quotes and backslashes as in a shell, and nothing else.
with_options = printf %s "$$OPTIONS" | xargs $(1)
pixel_files = $(OUT)/pixel/$(graded_lab)
.PHONY: pixels pixel
pixels: $(PIXELS)
pixel:  ## follow one pixel, step by step (outside the sandbox: own code only): LAB=03 AT=200,120 [SOLUTION=1] [OPTIONS="--scene ..."]
	+@$(call is_one_of,$(FOLLOWED),pixel to follow); test -n "$$AT" || { echo 'make $@: say which pixel: make $@ LAB=$(EXAMPLE_LAB) AT=200,120' >&2; exit 2; }; \
	    $(MAKE) -s --no-print-directory $(call own_program,pixel)
	@$(call with_options,$(call own_program,pixel) --pixel "$$AT" --json $(pixel_files).json --svg $(pixel_files).svg)
	@echo "written to $(pixel_files).json, drawn in $(pixel_files).svg"
