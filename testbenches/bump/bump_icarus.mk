# bump: light of a bump-mapped pixel from light, halfway vector, normal and bump vector
# make -f bump_icarus.mk           runs the testbench
# make -f bump_icarus.mk wave      runs it and writes a VCD
# HDL=DIR says where the module is, if not here.
HDL ?= .
TABLES = bump_sincos.hex bump_recip.hex bump_atan.hex bump_cos.hex bump_diffuse.hex bump_specular.hex
.PHONY: run wave clean
run: bump_tb.vvp $(TABLES)
	vvp -n $<
wave: bump_tb.vvp $(TABLES)
	vvp -n $< +vcd
bump_tb.vvp: $(HDL)/bump.v bump_tb.v
	iverilog -g2005 -Wall -o $@ $^
ifneq ($(HDL),.)
$(TABLES): %.hex: $(HDL)/%.hex
	cp $< $@
endif
clean:
	rm -f bump_tb.vvp bump_tb.vcd
