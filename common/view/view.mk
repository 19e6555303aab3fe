# How the windows of the labs are built: `make view`, `make movie`. Only they need SDL.

VIEWED := $(filter $(patsubst common/view/%.c,%,$(wildcard common/view/[0-9]*.c)),$(LABS))
VIEWS := $(foreach lab,$(VIEWED),$(patsubst %/lab.json,$(OUT)/view/%,$(wildcard labs/$(lab)/lab.json solutions/$(lab)/lab.json)))
VIEW_INCLUDES = -I common/view -I solutions/00-hello-pixels $(shell pkg-config --cflags sdl2 SDL2_ttf)

# What every window is made of.
VIEW_SOURCES := $(filter-out common/view/spheres.c,$(wildcard common/view/[a-z]*.c))
$(OUT)/obj/common/view/%.o: EXTRA = $(VIEW_INCLUDES)
$(OUT)/libview.a: $(call objects,$(VIEW_SOURCES))
	$(archive)

# And what is of its lab: a file of its own, the lab's host files but main.c, and from lab 05 on, whose
# buffers it uses, spheres.c.
view_parts = $(1) $(if $(wildcard $(addsuffix /scene_buffers.h,labs/$(1) solutions/$(1) $(addprefix solutions/,$(call earlier,$(1))))),spheres)
view_objects = $(patsubst %,$(OUT)/obj/view/$(1)/%.o,$(call view_parts,$(notdir $(1)))) \
    $(call objects,$(filter-out %/main.c,$(wildcard $(1)/*.c)))
viewed_lab = $(patsubst $(OUT)/obj/view/%/,%,$(dir $@))
$(OUT)/obj/view/%.o: EXTRA = $(VIEW_INCLUDES) -I $(viewed_lab) $(call include_path,$(notdir $(viewed_lab))) \
    -DLAB_NAME='"$(notdir $(viewed_lab))"' -DLAB_FOLDER='"$(viewed_lab)"' -DSTEPS_FOLDER='"common/view/steps"' \
    -DKERNEL_OPTIONS='"$(call include_path,$(notdir $(viewed_lab)))"'
$(OUT)/obj/view/%.o: common/view/$$(notdir $$*).c $(FLAG_FILES)
	@mkdir -p $(@D)
	$(call say,compile $< for $(viewed_lab))$(CC) $(CFLAGS) -MMD -MP $(INCLUDES) $(EXTRA) -c $< -o $@
$(VIEWS): LIBRARIES += -Wl,-rpath,'$$ORIGIN/../..' $(shell pkg-config --libs sdl2 SDL2_ttf)
$(VIEWS): $(OUT)/view/%: $$(call view_objects,$$*) $(OUT)/libview.a $(OUT)/earlier/$$(notdir $$*).a $(OUT)/libcommon.a | $(OUT)/libimage_codec.so
	$(call link,$(LIBRARIES))

# The student's own; with SOLUTION=1 the solution.
view_program = $(OUT)/view/$(if $(SOLUTION),solutions,labs)/$(graded_lab)
view_ready = test -n "$(filter $(graded_lab),$(VIEWED))" || { echo 'make $@: found LAB="$(LAB)", expected a lab that draws with a kernel: $(VIEWED)' >&2; exit 2; }; \
    common/setup/install.sh view && $(MAKE) -s --no-print-directory $(view_program)
.PHONY: views view movie
views: $(VIEWS)
view:  ## install what is missing, fly through LAB=03 in a window [SOLUTION=1] [OPTIONS="--size 800x600 ..."]
	+@$(view_ready)
	@$(view_program) $(OPTIONS)
movie:  ## once round the scene, as pictures and, with ffmpeg, as a film: LAB=03 [SOLUTION=1] [OPTIONS=...]
	+@$(view_ready)
	@common/view/movie.sh $(view_program) $(OUT)/movie/$(graded_lab) $(OPTIONS)
