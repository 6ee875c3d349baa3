# sampler: texels and fractions of texture coordinates, nearest or bilinear, wrapped or clamped
# make -f sampler_icarus.mk           runs the testbench
# make -f sampler_icarus.mk wave      runs it and writes a VCD
# HDL=DIR says where the module is, if not here.
HDL ?= .
.PHONY: run wave clean
run: sampler_tb.vvp
	vvp -n $<
wave: sampler_tb.vvp
	vvp -n $< +vcd
sampler_tb.vvp: $(HDL)/sampler.v sampler_tb.v
	iverilog -g2005 -Wall -o $@ $^
clean:
	rm -f sampler_tb.vvp sampler_tb.vcd
