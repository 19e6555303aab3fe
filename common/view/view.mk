# How the windows of the labs are built: `make view`, `make movie`. Only they need SDL. What they show,
# and what is followed in it, is common/follow's.

VIEWS := $(call programs_of,view,$(SEEN))
VIEW_INCLUDES = -I common/follow -I solutions/00-hello-pixels $(shell pkg-config --cflags sdl2 SDL2_ttf)

VIEW_SOURCES := $(wildcard common/view/*.c)
$(OUT)/obj/common/view/%.o: EXTRA = $(VIEW_INCLUDES)
$(VIEWS): LIBRARIES += -Wl,-rpath,'$$ORIGIN/../..' $(shell pkg-config --libs sdl2 SDL2_ttf)
$(VIEWS): $(OUT)/view/%: $(call objects,$(VIEW_SOURCES)) $$(call follow_objects,$$*) $(OUT)/libfollow.a \
    $(OUT)/earlier/$$(notdir $$*).a $(OUT)/libcommon.a | $(OUT)/libimage_codec.so
	$(call link,$(LIBRARIES))

# The student's own; with SOLUTION=1 the solution.
view_ready = $(call is_one_of,$(SEEN),window); common/setup/install.sh view && $(MAKE) -s --no-print-directory $(call own_program,view)
.PHONY: views view movie
views: $(VIEWS)
view:  ## install what is missing, fly through LAB=03 in a window (outside the sandbox: own code only) [SOLUTION=1] [OPTIONS="--size 800x600 ..."]
	+@$(view_ready)
	@$(call with_options,$(call own_program,view))
movie:  ## once round the scene, as pictures and, with ffmpeg, as a film (outside the sandbox: own code only): LAB=03 [SOLUTION=1] [OPTIONS=...]
	+@$(view_ready)
	@$(call with_options,common/view/movie.sh $(call own_program,view) $(OUT)/movie/$(graded_lab))
