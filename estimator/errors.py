"""The one exception that means "the request or its input is wrong"."""


class InputError(ValueError):
    """A user's mistake, told in one line: what was got, what was wanted, what there is.

    The command line prints the message without a traceback and exits with code 2.
    """
