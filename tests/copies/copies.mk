# Which answers of a class are alike (tests/copies/README.md). Not in a handout.

$(OUT)/libcopies.a: $(call objects,$(filter-out %_tool.c,$(wildcard tests/copies/*.c)))
	$(archive)
$(OUT)/tools/copies: $(call objects,tests/copies/copies_tool.c) $(OUT)/libcopies.a $(OUT)/libclass.a $(OUT)/libgrader.a $(OUT)/libcommon.a
	$(call link,$(LIBRARIES) $(CLASS_LIBRARIES))

grader: $(OUT)/tools/copies
.PHONY: copies
copies: $(addprefix $(OUT)/tools/,copies gradebook unpack)  ## which answers of a class are alike: LAB=03 SUBMISSIONS=folder or archive, or OUTPUT=folder of a graded class [EXPORT=jplag|dolos|moss]
	@tests/copies/copies.sh --build $(OUT) $(if $(LAB),--lab "$$LAB") \
	    $(if $(SUBMISSIONS),--submissions "$$SUBMISSIONS") $(if $(OUTPUT),--output "$$OUTPUT") \
	    $(if $(EXPORT),--export "$$EXPORT")
