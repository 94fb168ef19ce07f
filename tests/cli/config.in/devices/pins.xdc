set_property PACKAGE_PIN E3 [get_ports clk]
create_clock -period 10.0 [get_ports clk]
