# illumination: light of a pixel from light, halfway and perturbed normal vector in the texture frame
# make -f illumination_icarus.mk           runs the testbench
# make -f illumination_icarus.mk wave      runs it and writes a VCD
# HDL=DIR says where the module is, if not here.
HDL ?= .
.PHONY: run wave clean
run: illumination_tb.vvp
	vvp -n $<
wave: illumination_tb.vvp
	vvp -n $< +vcd
illumination_tb.vvp: $(HDL)/illumination.v illumination_tb.v
	iverilog -g2005 -Wall -o $@ $^
clean:
	rm -f illumination_tb.vvp illumination_tb.vcd
