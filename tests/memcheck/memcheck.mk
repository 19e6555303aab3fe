# How memcheck is built, in the course and in handouts of labs with kernels.

MEMCHECK_SOURCES := $(wildcard tests/memcheck/*.c)
$(OUT)/tools/memcheck: $(call objects,$(MEMCHECK_SOURCES)) $(OUT)/libgrader.a $(OUT)/libcommon.a | $(OUT)/libimage_codec.so
	$(call link,$(LIBRARIES))

grader: $(OUT)/tools/memcheck
.PHONY: memcheck
memcheck: graded $(OUT)/tools/memcheck  ## look for indices out of range, unset values and races: LAB=03 [SUBMISSION=folder]
	@$(say_which_lab)
	@$(OUT)/tools/memcheck --build $(OUT) --lab "$$LAB" \
	    $(if $(SUBMISSION),--submission "$$SUBMISSION") $(if $(SEED),--seed "$$SEED") \
	    $(if $(TIME_LIMIT),--time-limit "$$TIME_LIMIT") $(verdict_is_no_fault)
