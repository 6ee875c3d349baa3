# rotation: turns a direction in polar form into the frame of a surface normal
# make -f rotation_exact_icarus.mk           runs the testbench
# make -f rotation_exact_icarus.mk wave      runs it and writes a VCD
# HDL=DIR says where the module is, if not here.
HDL ?= .
.PHONY: run wave clean
run: rotation_exact_tb.vvp
	vvp -n $<
wave: rotation_exact_tb.vvp
	vvp -n $< +vcd
rotation_exact_tb.vvp: $(HDL)/rotation_exact.v rotation_exact_tb.v
	iverilog -g2005 -Wall -o $@ $^
clean:
	rm -f rotation_exact_tb.vvp rotation_exact_tb.vcd
