"""Result objects that users get, and their documents."""
