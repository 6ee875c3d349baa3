# kugler: light of a bump-mapped pixel by rotations and light maps, without dot products
# make -f kugler_icarus.mk           runs the testbench
# make -f kugler_icarus.mk wave      runs it and writes a VCD
# HDL=DIR says where the module is, if not here.
HDL ?= .
TABLES = kugler_recip.hex kugler_atan.hex kugler_tilt_map.hex kugler_diffuse_map.hex kugler_specular_map.hex
.PHONY: run wave clean
run: kugler_tb.vvp $(TABLES)
	vvp -n $<
wave: kugler_tb.vvp $(TABLES)
	vvp -n $< +vcd
kugler_tb.vvp: $(HDL)/kugler.v kugler_tb.v
	iverilog -g2005 -Wall -o $@ $^
ifneq ($(HDL),.)
$(TABLES): %.hex: $(HDL)/%.hex
	cp $< $@
endif
clean:
	rm -f kugler_tb.vvp kugler_tb.vcd
