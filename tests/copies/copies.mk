# Which answers of a class are alike (tests/copies/README.md). Not in a handout.

$(OUT)/libcopies.a: $(call objects,$(filter-out %_tool.c,$(wildcard tests/copies/*.c)))
	$(archive)
$(OUT)/tools/copies: $(call objects,tests/copies/copies_tool.c) $(OUT)/libcopies.a $(OUT)/libclass.a $(OUT)/libmutation.a $(OUT)/libgrader.a $(OUT)/libcommon.a
	$(call link,$(LIBRARIES) $(CLASS_LIBRARIES))

grader: $(OUT)/tools/copies
.PHONY: copies
copies: $(addprefix $(OUT)/tools/,copies gradebook unpack)  ## which answers of a class are alike: LAB=03 OUTPUT=folder of a graded class, or SUBMISSIONS=folder or archive [EXPORT=jplag|dolos|moss]; of several labs: CLASSES="folder folder ..." [OUTPUT=folder]
	$(if $(CLASSES),@set -f; $(OUT)/tools/copies --build $(OUT) -- term "$(if $(OUTPUT),$$OUTPUT,$(OUT)/term)" $$CLASSES,@exec tests/copies/copies.sh --build $(OUT) $(if $(LAB),--lab "$$LAB") \
	    $(if $(SUBMISSIONS),--submissions "$$SUBMISSIONS") $(if $(OUTPUT),--output "$$OUTPUT") \
	    $(if $(EXPORT),--export "$$EXPORT"))
