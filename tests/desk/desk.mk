# The learner's desk, in the course and in handouts: watch, hint, progress.

DESK_SOURCES := $(wildcard tests/desk/*.c)
$(OUT)/obj/tests/desk/%.o: EXTRA = $(GRADER_INCLUDES) -I tests/desk
$(OUT)/tools/desk: $(call objects,$(DESK_SOURCES)) $(OUT)/libgrader.a $(OUT)/libcommon.a | $(OUT)/libimage_codec.so
	$(call link,$(LIBRARIES))

grader: $(OUT)/tools/desk
needs_lab = test -n "$(graded_lab)" || { printf 'make $@: found LAB="%s", expected the number or name of a lab: $(LABS)\n' "$$LAB" >&2; exit 2; }
.PHONY: watch hint progress
watch: graded $(OUT)/tools/desk  ## after every save compile, draw and grade: LAB=03 [OPTIONS="--scene ..."] [DEVICE=d]
	+@$(say_which_lab); $(needs_lab)
	@$(OUT)/tools/desk watch --build $(OUT) --make "$(MAKE)" --lab $(graded_lab) $(if $(OPTIONS),--options "$$OPTIONS") $(if $(DEVICE),--device "$$DEVICE")
hint: $(OUT)/tools/desk  ## one more hint for the first fault of the last grading: LAB=03
	@$(say_which_lab); $(needs_lab)
	@$(OUT)/tools/desk hint --build $(OUT) --lab $(graded_lab) $(verdict_is_no_fault)
progress: $(OUT)/tools/desk  ## labs and tasks with points, hours planned, what is next
	@$(OUT)/tools/desk progress
