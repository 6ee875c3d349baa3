# {{ title }}
# make -f {{ name }}_ghdl.mk             runs the VHDL testbench
# make -f {{ name }}_ghdl.mk wave        runs it with a VCD
.PHONY: run wave clean
run: work-obj08.cf
	ghdl -r --std=08 {{ name }}_tb
wave: work-obj08.cf
	ghdl -r --std=08 {{ name }}_tb --vcd={{ name }}_tb.vcd
work-obj08.cf: {{ name }}.vhd {{ name }}_tb.vhd
	ghdl -a --std=08 $^
clean:
	rm -f work-obj08.cf {{ name }}_tb.vcd
