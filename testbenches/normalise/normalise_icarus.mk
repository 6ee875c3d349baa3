# normalise: block normalisation: three words shifted by the leading zeros of the largest
# make -f normalise_icarus.mk           runs the testbench
# make -f normalise_icarus.mk wave      runs it and writes a VCD
# HDL=DIR says where the module is, if not here.
HDL ?= .
.PHONY: run wave clean
run: normalise_tb.vvp
	vvp -n $<
wave: normalise_tb.vvp
	vvp -n $< +vcd
normalise_tb.vvp: $(HDL)/normalise.v normalise_tb.v
	iverilog -g2005 -Wall -o $@ $^
clean:
	rm -f normalise_tb.vvp normalise_tb.vcd
