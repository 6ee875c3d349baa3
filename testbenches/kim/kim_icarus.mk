# kim: light of a bump-mapped pixel by a matrix of sines and cosines and polar dot products
# make -f kim_icarus.mk           runs the testbench
# make -f kim_icarus.mk wave      runs it and writes a VCD
# HDL=DIR says where the module is, if not here.
HDL ?= .
TABLES = kim_sincos.hex kim_recip.hex kim_atan.hex kim_diffuse.hex kim_specular.hex
.PHONY: run wave clean
run: kim_tb.vvp $(TABLES)
	vvp -n $<
wave: kim_tb.vvp $(TABLES)
	vvp -n $< +vcd
kim_tb.vvp: $(HDL)/kim.v kim_tb.v
	iverilog -g2005 -Wall -o $@ $^
ifneq ($(HDL),.)
$(TABLES): %.hex: $(HDL)/%.hex
	cp $< $@
endif
clean:
	rm -f kim_tb.vvp kim_tb.vcd
