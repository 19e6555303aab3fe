# The learner's desk, in the course and in handouts: watch, hint, progress. Bundles have none.

DESK_SOURCES := $(wildcard tests/desk/*.c)
$(OUT)/obj/tests/desk/%.o: EXTRA = $(GRADER_INCLUDES) -I tests/desk
DESK := $(OUT)/tools/desk
$(DESK): $(call objects,$(DESK_SOURCES)) $(OUT)/libgrader.a $(OUT)/libcommon.a | $(OUT)/libimage_codec.so
	$(call link,$(LIBRARIES))

grader: $(DESK)
# Under another name: make runs a line with its own name in it even in a dry run.
make_program := $(MAKE)
# What make grade does behind a verdict on one's own answers.
note_own = @$(DESK) note --build $(OUT) --lab $(graded_lab) || true
# Where it cannot be built, the watch does without.
build_native = env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL "$(make_program)" --no-print-directory lab-native LAB=$(graded_lab) BUILD=$(BUILD) 2>/dev/null
needs_lab = test -n "$(graded_lab)" || { printf 'make $@: found LAB="%s", expected the number or name of a lab: $(LABS)\n' "$$LAB" >&2; exit 2; }
.PHONY: watch hint progress
watch: graded $(DESK)  ## after every save compile, draw (outside the sandbox: own code only) and grade: LAB=03 [OPTIONS="--scene ..."] [DEVICE=d]
	@$(say_which_lab); $(needs_lab)
	@set --; ! test -n "$(NATIVE_CLANG)" || ! $(build_native) || set -- --native $(OUT)/native; \
	    $(DESK) watch "$$@" --build $(OUT) --make "$(make_program)" --lab $(graded_lab) $(if $(OPTIONS),--options "$$OPTIONS") $(if $(DEVICE),--device "$$DEVICE")
hint: $(DESK)  ## one more hint for the first fault of the last grading: LAB=03
	@$(say_which_lab); $(needs_lab)
	@$(DESK) hint --build $(OUT) --lab $(graded_lab) $(verdict_is_no_fault)
progress: $(DESK)  ## labs and tasks with points, hours planned, what is next
	@$(DESK) progress
