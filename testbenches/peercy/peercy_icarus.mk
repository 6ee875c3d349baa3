# peercy: light and halfway vector in the texture frame, by matrix, with the bump vector normalised
# make -f peercy_icarus.mk           runs the testbench
# make -f peercy_icarus.mk wave      runs it and writes a VCD
# HDL=DIR says where the module is, if not here.
HDL ?= .
.PHONY: run wave clean
run: peercy_tb.vvp
	vvp -n $<
wave: peercy_tb.vvp
	vvp -n $< +vcd
peercy_tb.vvp: $(HDL)/peercy.v peercy_tb.v
	iverilog -g2005 -Wall -o $@ $^
clean:
	rm -f peercy_tb.vvp peercy_tb.vcd
