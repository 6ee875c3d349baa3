# {{ title }}
# make -f {{ name }}_ghdl.mk             runs the VHDL testbench
# make -f {{ name }}_ghdl.mk wave        runs it with a VCD
.PHONY: run wave clean
# A library for this module alone. It holds paths: after the folder has moved, make clean.
GHDL = --std=08 --workdir=ghdl_{{ name }}
run: ghdl_{{ name }}/work-obj08.cf
	ghdl -r $(GHDL) {{ name }}_tb
wave: ghdl_{{ name }}/work-obj08.cf
	ghdl -r $(GHDL) {{ name }}_tb --vcd={{ name }}_tb.vcd
ghdl_{{ name }}/work-obj08.cf: {{ name }}.vhd {{ name }}_tb.vhd
	rm -rf ghdl_{{ name }}
	mkdir ghdl_{{ name }}
	ghdl -a $(GHDL) $^
clean:
	rm -rf ghdl_{{ name }} {{ name }}_tb.vcd
