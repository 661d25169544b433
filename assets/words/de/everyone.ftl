# everyone
