# combine: diffuse light plus the differences of height samples: the emboss of one to eight lights
# make -f combine_icarus.mk           runs the testbench
# make -f combine_icarus.mk wave      runs it and writes a VCD
# HDL=DIR says where the module is, if not here.
HDL ?= .
.PHONY: run wave clean
run: combine_tb.vvp
	vvp -n $<
wave: combine_tb.vvp
	vvp -n $< +vcd
combine_tb.vvp: $(HDL)/combine.v combine_tb.v
	iverilog -g2005 -Wall -o $@ $^
clean:
	rm -f combine_tb.vvp combine_tb.vcd
