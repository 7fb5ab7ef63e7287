"""How good: errors, reports and the command line. The only room that may see estimate and truth together."""
